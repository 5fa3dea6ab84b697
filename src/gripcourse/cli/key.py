"""The command on the key of the signatures: parse, one call, print, exit code. No logic."""

from gripcourse.cli.help import SpokenCommand, command_group
from gripcourse.cli.loudness import confirm
from gripcourse.cli.options import CourseOption, LanguageOption, course_folder, words_for
from gripcourse.text.words import message

app = command_group("The key that signs what is issued.")


@app.command("rotate", cls=SpokenCommand)
def rotate(*, course: CourseOption = None, language: LanguageOption = None) -> None:
    """Sign with a new key from now on; what was issued before stays verifiable."""
    from gripcourse.usecases.issuing.key import rotate as command  # noqa: PLC0415 (not for --help)

    place = command(course_folder(course))
    said = message("A new key signs from now on: {place}. Keep a copy of it.", place=str(place))
    confirm(words_for(language).say(said))
