"""The student's way in a real browser: without scripts, by keyboard, on a telephone's width.

The server is a real one, in a process of its own, with real workers.
"""

import json
import os
import re
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from importlib.resources import files
from pathlib import Path
from shutil import which
from typing import TYPE_CHECKING
from urllib.error import URLError

import pytest
from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.expected_conditions import staleness_of
from selenium.webdriver.support.wait import WebDriverWait

from gripcourse.machine.content import NamedBytes
from gripcourse.text.words import LANGUAGES
from gripcourse.usecases.grading.batch_tables import GRADES_JSON
from gripcourse.usecases.publishing.publish import publish, withdraw
from gripcourse.usecases.serving.hand_in import hand_in
from gripcourse.usecases.serving.sign_in import offer_sign_in
from support.processes import wait_for

if TYPE_CHECKING:
    from selenium.webdriver.remote.webdriver import WebDriver

    from web.conftest import Server

FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
)
SECONDS = 60.0
DRAWING = b'<svg xmlns="http://www.w3.org/2000/svg"><rect width="9" height="9"/></svg>'
AXE = files("axe_playwright_python").joinpath("axe.min.js").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def address(opened: "Server") -> Iterator[str]:
    """Where the server of the command line listens."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [
        *(sys.executable, "-m", "gripcourse", "serve", "--port", str(port), "--workers", "1"),
        *("--course", str(opened.classroom.course.root)),
        *("--assignments", str(opened.classroom.order.out), "--graded", str(opened.graded)),
    ]
    opened.graded.mkdir(exist_ok=True)
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL)  # noqa: S603 (ourselves)
    url = f"http://127.0.0.1:{port}"

    def answers() -> bool:
        assert running.poll() is None
        try:
            urllib.request.urlopen(url, timeout=SECONDS).close()
        except (URLError, OSError):
            return False
        return True

    wait_for(answers)
    yield url
    running.terminate()
    assert running.wait(SECONDS) in (0, -15)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator["WebDriver"]:
    """Chromium that runs no script of any page."""
    if which("chromium") is None or which("chromedriver") is None:
        pytest.skip("Debian's chromium and chromium-driver are not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = str(which("chromium"))
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    service = webdriver.ChromeService(str(which("chromedriver")))
    driver = webdriver.Chrome(options, service)
    run_scripts(driver, allowed=False)
    driver.get("data:text/html,<title>still</title><script>document.title = 'ran'</script>")
    assert driver.title == "still"
    yield driver
    driver.quit()


def run_scripts(browser: "WebDriver", *, allowed: bool) -> None:
    """Let pages run scripts, or not; what a test asks the browser itself runs always."""
    browser.execute_cdp_cmd(  # type: ignore[attr-defined]
        "Emulation.setScriptExecutionDisabled", {"value": not allowed}
    )


def show(browser: "WebDriver", name: str) -> None:
    """Keep a picture where somebody asked for pictures."""
    folder = os.environ.get("GRIPCOURSE_SCREENSHOTS")
    if folder:
        Path(folder).mkdir(parents=True, exist_ok=True)
        browser.save_screenshot(str(Path(folder) / f"{name}.png"))


def focused(browser: "WebDriver") -> str:
    one = browser.switch_to.active_element
    return one.get_attribute("id") or one.text


def tab_to(browser: "WebDriver", wanted: str) -> None:
    """Press the tabulator until something has the focus."""
    for _ in range(30):
        ActionChains(browser).send_keys(Keys.TAB).perform()
        if focused(browser) == wanted:
            return
    raise AssertionError(wanted)


@contextmanager
def another_page(browser: "WebDriver") -> Iterator[None]:
    """Wait until what is pressed here has led to another page: a press itself waits for nothing."""
    before = browser.find_element(By.TAG_NAME, "html")
    yield
    # Between two pages the browser may answer that an element is of neither: it is asked again.
    waiting = WebDriverWait(browser, SECONDS, ignored_exceptions=[WebDriverException])
    waiting.until(staleness_of(before))


@pytest.mark.parametrize(
    ("student", "language", "check", "hand_in", "understood"),
    [
        ("s01", "ru", "Проверить файл", "Сдать файл", "Понято как"),
        ("s02", "uk", "Перевірити файл", "Здати файл", "Зрозуміло як"),
        ("s03", "en", "Check it", "Hand it in", "Understood as"),
    ],
)
def test_a_student_checks_and_hands_in_by_keyboard_alone_without_scripts(  # noqa: PLR0913, PLR0917 (fixtures, and the words of a language)
    server: "Server",
    address: str,
    browser: "WebDriver",
    tmp_path: Path,
    student: str,
    language: str,
    check: str,
    hand_in: str,
    understood: str,
) -> None:
    work = tmp_path / "work.xlsx"
    work.write_bytes(server.filled(student, tmp_path))
    home = f"{address}{server.home(student, days=4000)}"
    browser.set_window_size(1200, 1000)
    browser.get(home)
    show(browser, f"{language}-assignment")
    assert browser.find_element(By.TAG_NAME, "html").get_attribute("lang") == language
    browser.find_element(By.ID, "file").send_keys(str(work))
    tab_to(browser, check)
    with another_page(browser):
        ActionChains(browser).send_keys(Keys.ENTER).perform()
    show(browser, f"{language}-checked")
    assert understood in browser.find_element(By.TAG_NAME, "thead").text
    answers = browser.find_elements(By.CSS_SELECTOR, "tr.state-read")
    assert len(answers) > 20
    assert re.search(r"\d", answers[0].find_elements(By.TAG_NAME, "td")[1].text)
    browser.get(home)
    browser.find_element(By.ID, "file").send_keys(str(work))
    tab_to(browser, hand_in)
    with another_page(browser):
        ActionChains(browser).send_keys(Keys.ENTER).perform()
    show(browser, f"{language}-receipt")
    assert "/receipt/" in browser.current_url
    assert browser.find_element(By.CSS_SELECTOR, ".notice.good").get_attribute("role") == "status"


def test_nothing_is_wider_than_a_telephone(
    server: "Server", address: str, browser: "WebDriver", tmp_path: Path
) -> None:
    work = tmp_path / "work.xlsx"
    work.write_bytes(server.filled("s01", tmp_path))
    browser.execute_cdp_cmd(  # type: ignore[attr-defined]
        "Emulation.setDeviceMetricsOverride",
        {"width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": True},
    )
    browser.get(f"{address}{server.home('s01', days=4000)}")
    for name in ("phone-assignment", "phone-checked"):
        show(browser, name)
        size = browser.execute_cdp_cmd("Page.getLayoutMetrics", {})  # type: ignore[attr-defined]
        assert size["cssContentSize"]["width"] <= 360
        if name == "phone-assignment":
            browser.find_element(By.ID, "file").send_keys(str(work))
            tab_to(browser, "Проверить файл")
            with another_page(browser):
                ActionChains(browser).send_keys(Keys.ENTER).perform()
    browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})  # type: ignore[attr-defined]


def test_every_field_has_a_name_and_every_page_one_heading(
    server: "Server", address: str, browser: "WebDriver"
) -> None:
    browser.get(f"{address}{server.home('s03', days=4000)}")
    assert len(browser.find_elements(By.TAG_NAME, "h1")) == 1
    for one in browser.find_elements(By.CSS_SELECTOR, "input, select, textarea, button, a"):
        assert one.accessible_name, one.get_attribute("outerHTML")


def flag_first(path: Path) -> None:
    """Let the first work of a batch have a flag with evidence."""
    grades = json.loads(path.read_text(encoding="utf-8"))
    flag = {"code": "same_answers", "message": "Числа те же.", "others": ["s01"]}
    grades["reports"][0]["flags"].append({**flag, "rests_on": ["grip_force", "drive_force"]})
    path.write_text(json.dumps(grades), encoding="utf-8")


@pytest.fixture(scope="module")
def published(opened: "Server", tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """The first student has handed in and sees results; somebody asks for another look."""
    folder, context, now = tmp_path_factory.mktemp("published"), opened.context, opened.clock.now
    issued = opened.classroom.register["s01"]
    long = f"{'исправлено_окончательно_' * 3}.xlsx"
    files = {long: opened.filled("s01", folder), "view.svg": DRAWING}
    for name, data in files.items():
        hand_in(context, issued, NamedBytes(name, data), now)
    opened.grade(folder)
    flag_first(opened.graded / GRADES_JSON)
    publish(context, opened.graded, "Dr. Ray", "term over", now)
    context.desk.add_request("s01", "grip_force", f"Please look again{'!' * 200}", now)
    yield
    withdraw(context, "Dr. Ray", "", now)


@pytest.fixture(scope="module")
def desk(opened: "Server", address: str, browser: "WebDriver") -> str:
    """The desk, signed in."""
    token = offer_sign_in(opened.context, "Dr. Ray", datetime.now(UTC))
    browser.get(f"{address}/desk/sign-in/{token}")
    assert broken_rules(browser) == []
    with another_page(browser):
        browser.find_element(By.TAG_NAME, "button").click()
    return f"{address}/desk/"


def broken_rules(browser: "WebDriver") -> list[str]:
    """Return which rules of axe a page breaks, and where; and whether it is too wide."""
    run_scripts(browser, allowed=True)  # axe waits by timers, which the page would not run
    browser.execute_script(AXE)
    found = browser.execute_async_script(
        "const done = arguments[0];"
        " axe.run({resultTypes: ['violations']}).then(done, fault => done(String(fault)))"
    )
    beyond = browser.execute_script(
        "const all = document.documentElement; return all.scrollWidth - all.clientWidth"
    )
    run_scripts(browser, allowed=False)
    assert isinstance(found, dict), found
    assert len(found["passes"]) > 10
    return ["wider than its window"] * (beyond > 0) + [
        f"{one['id']}: {one['help']}: {node['html'][:200]}"
        for one in found["violations"]
        for node in one["nodes"]
    ]


def read_in(browser: "WebDriver", language: str) -> None:
    """Let the browser ask for pages in a language."""
    headers = {"headers": {"Accept-Language": language}}
    browser.execute_cdp_cmd("Network.enable", {})  # type: ignore[attr-defined]
    browser.execute_cdp_cmd("Network.setExtraHTTPHeaders", headers)  # type: ignore[attr-defined]


def upload(browser: "WebDriver", work: Path) -> None:
    browser.find_element(By.ID, "file").send_keys(str(work))
    with another_page(browser):
        browser.find_element(By.CSS_SELECTOR, "form[action$=check] button").click()


SIZES = {
    "desktop": {"width": 1200, "height": 1000, "deviceScaleFactor": 1, "mobile": False},
    "phone": {"width": 360, "height": 740, "deviceScaleFactor": 2, "mobile": True},
}


@pytest.fixture(params=SIZES)
def sized(request: pytest.FixtureRequest, browser: "WebDriver") -> Iterator["WebDriver"]:
    """The browser on a desk, and on a telephone."""
    size = SIZES[request.param]
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)  # type: ignore[attr-defined]
    yield browser
    browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})  # type: ignore[attr-defined]


@pytest.mark.usefixtures("published")
def test_no_page_of_a_student_breaks_a_rule_of_accessibility(
    server: "Server", address: str, sized: "WebDriver", tmp_path: Path
) -> None:
    homes = {name: f"{address}{server.home(name, days=4000)}" for name in ("s01", "s02", "s03")}
    work, other = tmp_path / "work.xlsx", tmp_path / "other.xlsx"
    work.write_bytes(server.filled("s03", tmp_path))
    other.write_bytes(b"no workbook")
    broken: dict[str, list[str]] = {}

    def look(page: str) -> None:
        show(sized, f"axe-{page}-{sized.execute_script('return innerWidth')}")
        broken[page] = broken_rules(sized)

    for name, home in homes.items():
        sized.get(home)
        look(f"assignment of {name}")
    for file in (work, other):
        sized.get(homes["s03"])
        upload(sized, file)
        look(f"check of {file.name}")
    sized.get(f"{homes['s01']}receipt/1")
    look("receipt")
    sized.get(f"{address}/s/forged/")
    look("notice")
    sized.get(address)
    look("welcome")
    assert {page: rules for page, rules in broken.items() if rules} == {}


@pytest.mark.usefixtures("published")
def test_no_page_of_the_desk_breaks_a_rule_of_accessibility(desk: str, sized: "WebDriver") -> None:
    broken = {}
    pages = ("", "student/s01", "student/s03", "?state=asks", "student/nobody", "marking")
    more = ("marking/s01/general_view_drawing", "regrading", "figures", "flags", "grading")
    # Each page in another language than its neighbour, and on the telephone than on the desk.
    turn = int(sized.execute_script("return innerWidth") < SIZES["desktop"]["width"])
    for number, page in enumerate((*pages, *more), turn):
        language = LANGUAGES[number % len(LANGUAGES)]
        read_in(sized, language)
        sized.get(f"{desk}{page}")
        assert sized.find_element(By.TAG_NAME, "html").get_attribute("lang") == language
        show(
            sized, f"axe-desk-{page.replace('/', '-')}-{sized.execute_script('return innerWidth')}"
        )
        broken[page] = broken_rules(sized)
    read_in(sized, "en")
    assert {page: rules for page, rules in broken.items() if rules} == {}


@pytest.mark.usefixtures("published")
def test_both_sides_see_at_once_what_the_other_does(
    server: "Server", desk: str, address: str, browser: "WebDriver", tmp_path: Path
) -> None:
    run_scripts(browser, allowed=False)
    work, sentence = tmp_path / "both.xlsx", "Look at both sides."
    work.write_bytes(server.filled("s01", tmp_path))
    at_desk, home = browser.current_window_handle, f"{address}{server.home('s01', days=4000)}"
    browser.switch_to.new_window("tab")
    at_home = browser.current_window_handle

    def press(action: str) -> None:
        with another_page(browser):
            browser.find_element(By.CSS_SELECTOR, f"form[action$={action}] button").click()

    def the_student(page: str) -> None:
        browser.switch_to.window(at_home)
        browser.get(page)

    def the_instructor(page: str) -> str:
        browser.switch_to.window(at_desk)
        browser.get(f"{desk}{page}")
        return browser.find_element(By.TAG_NAME, "main").text

    the_student(home)
    browser.find_element(By.ID, "file").send_keys(str(work))
    with another_page(browser):
        browser.find_element(By.CSS_SELECTOR, "button[formaction$=hand-in]").click()
    assert "/receipt/" in browser.current_url
    assert work.name in the_instructor("student/s01")
    the_student(home)
    browser.find_element(By.NAME, "sentence").send_keys(sentence)
    press("request")
    assert sentence in the_instructor("student/s01")
    the_instructor("")
    press("withdraw")
    the_student(home)
    assert not browser.find_elements(By.NAME, "sentence")
    the_instructor("")
    press("publish")
    the_student(home)
    assert browser.find_elements(By.NAME, "sentence")
    browser.close()
    browser.switch_to.window(at_desk)
