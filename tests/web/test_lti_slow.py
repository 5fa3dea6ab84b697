"""A learning platform that does not answer stops its own people, and nobody else."""

from dataclasses import replace
from pathlib import Path
from urllib.parse import parse_qsl, urlsplit

import anyio
import httpx2

from gripcourse.policy.model import Policy
from gripcourse.usecases.serving.lti import register_platform
from support.lti_course import LtiCourse, declared_as, open_lti_course
from support.platform import TOOL, StandIn, running

MORE_THAN_THREADS = 45


async def answer_of(browser: httpx2.AsyncClient, platform: StandIn, hint: str) -> dict[str, str]:
    """Open the assignment in a platform; return what the browser brings back from it."""
    sent = {"iss": platform.address, "login_hint": hint}
    begun = await browser.get("/lti/login", params=sent)
    asked = dict(parse_qsl(urlsplit(begun.headers["location"]).query))
    token = platform.token(platform.claims(hint, asked["nonce"]))
    return {"id_token": token, "state": asked["state"]}


async def crowd(school: LtiCourse, silent: StandIn) -> list[str]:
    """Let more come from a silent platform than there are threads, and one from another."""
    happened: list[str] = []
    transport = httpx2.ASGITransport(school.app())  # type: ignore[arg-type]
    async with httpx2.AsyncClient(transport=transport, base_url=TOOL) as browser:

        async def come(form: dict[str, str]) -> None:
            answer = await browser.post("/lti/launch", data=form)
            happened.append(f"silent {answer.status_code}")

        forms = [await answer_of(browser, silent, "anna") for _ in range(MORE_THAN_THREADS)]
        silent.may_answer.clear()
        async with anyio.create_task_group() as group:
            for form in forms:
                group.start_soon(come, form)
            while not silent.asked:  # noqa: ASYNC110 (told by a thread without a loop)
                await anyio.sleep(0.01)
            form = await answer_of(browser, school.platform, "anna")
            launched = await browser.post("/lti/launch", data=form)
            page = await browser.get(launched.headers["location"])
            happened.append(f"other {page.status_code}")
            silent.may_answer.set()
    return happened


def test_more_people_than_threads_of_a_silent_platform_stop_nobody_of_another(
    tmp_path: Path, policy: Policy
) -> None:
    with (
        open_lti_course(tmp_path, policy) as school,
        running(lambda: school.clock().timestamp()) as silent,
    ):
        silent.users.update(school.platform.users)
        register_platform(school.context.course.root, replace(declared_as(silent), name="silent"))
        happened = anyio.run(crowd, school, silent)
    assert happened == ["other 200", *["silent 303"] * MORE_THAN_THREADS]
    assert silent.asked == 1
