"""Pictures of the server's pages, on a desk and on a telephone, for docs/gallery/.

    scripts/gallery_server.py OUT PICTURES

OUT is the folder that the demo was made in; it is copied, and the server runs on the copy. Students
check and hand in, an instructor signs in, all through a browser without a window.
"""

import csv
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from shutil import which
from urllib.error import URLError
from urllib.request import urlopen

from PIL import Image
from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver.common.by import By
from selenium.webdriver.support.expected_conditions import staleness_of
from selenium.webdriver.support.wait import WebDriverWait

from gripcourse.course.load import load_course
from gripcourse.issuing.store import read_register

DESK, TELEPHONE = (1200, 900), (390, 844)
SHADES = 64
SECONDS = 120
STUDENT, UKRAINIAN, READER = "smirnova-ev", "shevchenko-ok", "carter-jl"
ITEM = "general_view_drawing"
PAGES_OF_THE_DESK = {
    "group": "",
    "student": f"student/{STUDENT}",
    "figures": "figures",
    "flags": "flags",
    "regrading": "regrading",
}
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage")


def main(out: Path, pictures: Path) -> None:
    """Write the picture of every page of the server.

    Raises:
        OSError: a folder cannot be read or written, or there is no browser.
    """
    with tempfile.TemporaryDirectory() as made:
        copy = Path(made) / "out"
        shutil.copytree(out, copy)
        with served(copy) as address, browser(Path(made)) as window:
            view = Camera(window, pictures)
            view.students(address, copy)
            view.desk(address, copy)


class Camera:
    """A browser, and where its pictures go."""

    def __init__(self, window: webdriver.Chrome, pictures: Path) -> None:
        """Keep both."""
        self.window = window
        self.pictures = pictures

    def students(self, address: str, out: Path) -> None:
        """Look at what students see: their assignment, a check, the receipt, their results."""
        homes = links_of(address, out)
        work = out / "submissions" / f"{STUDENT}.xlsx"
        self.window.get(homes[READER])
        self.take("server_assignment", DESK)
        self.window.get(homes[UKRAINIAN])
        self.take("server_results", DESK)
        self.window.get(homes[STUDENT])
        self.take("server_assignment_phone", TELEPHONE)
        self.send(work, "check")
        self.take("server_check", DESK)
        self.take("server_check_phone", TELEPHONE)
        self.window.get(homes[STUDENT])
        self.send(work, "hand-in")
        self.take("server_receipt_phone", TELEPHONE)
        for file in (drawing_of(UKRAINIAN, out), out / "submissions" / f"{UKRAINIAN}.xlsx"):
            self.window.get(homes[UKRAINIAN])
            self.send(file, "hand-in")

    def desk(self, address: str, out: Path) -> None:
        """Look at what an instructor sees."""
        link = said("sign-in", "--address", address, "--course", out / "course", "--by", "Dr. Ray")
        self.window.get(link.split()[-1])
        self.press("button")
        for name, page in PAGES_OF_THE_DESK.items():
            self.window.get(f"{address}/desk/{page}")
            self.take(f"server_desk_{name}", DESK)
        self.window.get(f"{address}/desk/")
        self.take("server_desk_phone", TELEPHONE)
        self.window.get(f"{address}/desk/marking")
        self.press(f"a[href*='marking/{UKRAINIAN}/{ITEM}']")
        self.take("server_desk_marking", DESK)

    def send(self, file: Path, act: str) -> None:
        """Choose a file and press a button of the same form."""
        self.window.find_element(By.ID, "file").send_keys(str(file))
        self.press(f"[action$='{act}'] button, [formaction$='{act}']")

    def press(self, what: str) -> None:
        """Press what a selector finds; return when another page has taken the place of this one."""
        found = self.window.find_element(By.CSS_SELECTOR, what)
        found.click()
        # At the change itself the browser may call the element nobody's, and gone a moment later.
        WebDriverWait(self.window, SECONDS, ignored_exceptions=[WebDriverException]).until(
            staleness_of(found)
        )

    def take(self, name: str, size: tuple[int, int]) -> None:
        """Write a picture of what the window shows, of few colours."""
        width, height = size
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.window.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        path = self.pictures / f"{name}.png"
        self.window.save_screenshot(str(path))
        with Image.open(path) as image:
            image.convert("RGB").quantize(SHADES).save(path, optimize=True)


@contextmanager
def served(out: Path) -> Iterator[str]:
    """Run the server on what the demo made, with results let out; yield its address."""
    said("release", out / "graded", "--course", out / "course", "--by", "Dr. Ray")
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    address = f"http://127.0.0.1:{port}"
    folders = ("--assignments", out / "assignments", "--graded", out / "graded")
    command = words("serve", "--course", out / "course", "--port", port, "--workers", "1", *folders)
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL)  # noqa: S603 (own words)
    try:
        wait_for(address)
        yield address
    finally:
        running.terminate()
        running.wait(SECONDS)


def wait_for(address: str) -> None:
    """Return when the server answers."""
    ends = time.monotonic() + SECONDS
    while True:
        try:
            urlopen(address, timeout=1).close()  # noqa: S310 (own address)
        except (URLError, OSError):
            if time.monotonic() > ends:
                raise
            time.sleep(0.2)
        else:
            return


@contextmanager
def browser(folder: Path) -> Iterator[webdriver.Chrome]:
    """Open a browser without a window."""
    options = webdriver.ChromeOptions()
    options.binary_location = str(which("chromium"))
    for flag in (*FLAGS, "--hide-scrollbars", f"--user-data-dir={folder / 'profile'}"):
        options.add_argument(flag)
    window = webdriver.Chrome(options, webdriver.ChromeService(str(which("chromedriver"))))
    try:
        yield window
    finally:
        window.quit()


def drawing_of(student: str, out: Path) -> Path:
    """Return the general view of a student's variant, as he might have drawn it."""
    variant = read_register(out / "course", load_course(out / "course").id).by_student()[student]
    said("draw", variant.variant.id, "--course", out / "course", "--out", out / "drawn")
    return next((out / "drawn").glob("*.svg"))


def links_of(address: str, out: Path) -> dict[str, str]:
    """Return the personal link of each student."""
    file = out / "links.csv"
    said("links", "--course", out / "course", "--address", address, "--out", file)
    with file.open(encoding="utf-8-sig", newline="") as rows:
        sample = rows.read(4096)
        rows.seek(0)
        table = csv.reader(rows, csv.Sniffer().sniff(sample, ";,\t"))
        next(table)
        return {row[0]: next(cell for cell in row if cell.startswith("http")) for row in table}


def words(*command: object) -> list[str]:
    """Return a command of the program, in English."""
    return [sys.executable, "-m", "gripcourse", *map(str, command), "--language", "en"]


def said(*command: object) -> str:
    """Run a command; return what it said."""
    done = subprocess.run(words(*command), check=True, capture_output=True, text=True)  # noqa: S603 (own words)
    return done.stdout


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
