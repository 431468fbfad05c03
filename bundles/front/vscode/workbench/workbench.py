"""Uses the extension as people do, in a real VS Code (code-server) in a browser without a window.

workbench.py CODE-SERVER VSIX OUT: CODE-SERVER is the folder of the package, OUT gets screenshots, the log and the data.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path

from selenium import webdriver
from selenium.common.exceptions import WebDriverException
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement

REPOSITORY = Path(__file__).resolve().parents[4]
PORT = 18_099
ADDRESS = f"http://127.0.0.1:{PORT}"
SETTINGS = {
    "editor.hover.delay": 100,
    "editor.quickSuggestions": {"other": "off"},
    "files.autoSave": "off",
    "git.openRepositoryInParentFolders": "never",
    "security.workspace.trust.enabled": False,
    "telemetry.telemetryLevel": "off",
    "window.menuBarVisibility": "classic",
    "workbench.startupEditor": "none",
    "workbench.tips.enabled": False,
}
TEMPLATE = """[comment encoding = UTF-8 /]
[**
 * Lists the components of a chain.
 */]
[module list('http://eventchain.dev/eventchain/1.0')]

[query public isFast(node : SoftwareNode) : Boolean = node.frequency >= 20.0 /]

[template public main(chain : EventChain)]
[comment @main /]
[file (chain.name.concat('.txt'), false, 'UTF-8')]
[for (node : SoftwareNode | chain.software->sortedBy(name)) separator ('\\n')]
[if (node.isFast())]
[node.name/]: [if node.frequency > 100 then 'fast' else 'quite fast' endif/]
[else]
[node.name/]: slow
[/if]
[/for]
[/file]
[/template]
"""
CONSTRAINTS = """-- Rules of this project.
context SoftwareNode
  def: isFast : Boolean = self.frequency >= 20.0
  inv FastEnough: -- as agreed
    self.isFast or self.name.startsWith('Slow') /* until release 2 */

context EventChain
  inv HasComponents: let all : Set(SoftwareNode) = self.software->asSet() in all->notEmpty()
"""


class Workbench:
    """A workbench with one folder open, in a browser."""

    def __init__(self, code_server: Path, out: Path) -> None:
        self.out = out
        self.folder = out / "workspace"
        self.started = time.monotonic()
        user = out / "data/User"
        user.mkdir(parents=True)
        (user / "settings.json").write_text(json.dumps(SETTINGS))
        self.command = [
            "node",
            str(code_server / "out/node/entry.js"),
            "--user-data-dir",
            str(out / "data"),
            "--extensions-dir",
            str(out / "ext"),
        ]
        self.env = os.environ | {"XDG_CONFIG_HOME": str(out / "config"), "XDG_DATA_HOME": str(out / "share")}

    def install(self, vsix: Path) -> None:
        """Installs the extension."""
        ended = subprocess.run(
            [*self.command, "--install-extension", str(vsix)], env=self.env, capture_output=True, text=True, timeout=300
        )
        if "successfully installed" not in ended.stdout:
            sys.exit(ended.stdout + ended.stderr)
        self.say("installed")

    def open(self) -> None:
        """Starts the server and the browser."""
        arguments = [
            "--auth",
            "none",
            "--disable-telemetry",
            "--disable-update-check",
            "--bind-addr",
            f"127.0.0.1:{PORT}",
            str(self.folder),
        ]
        with (self.out / "server.log").open("w") as log:
            self.server = subprocess.Popen([*self.command, *arguments], env=self.env, stdout=log, stderr=log)
        for _ in range(300):
            try:
                urllib.request.urlopen(f"{ADDRESS}/healthz", timeout=1)
                break
            except (urllib.error.URLError, TimeoutError):
                time.sleep(0.2)
        options = webdriver.ChromeOptions()
        for argument in (
            "--headless=new",
            "--no-sandbox",
            "--window-size=1400,900",
            "--disable-dev-shm-usage",
            "--no-first-run",
        ):
            options.add_argument(argument)
        options.binary_location = shutil.which("chromium") or ""
        self.browser = webdriver.Chrome(
            options=options, service=webdriver.ChromeService(shutil.which("chromedriver") or "")
        )
        self.browser.get(f"{ADDRESS}/?folder={self.folder}")
        self.wait("workbench", lambda: self.all(".explorer-folders-view .monaco-list-row"))

    def close(self) -> None:
        """Ends the browser and the server."""
        if hasattr(self, "browser"):
            self.browser.quit()
        self.server.terminate()
        self.server.wait(30)

    def say(self, text: str) -> None:
        """Prints what has been reached, with the time."""
        print(f"{time.monotonic() - self.started:6.1f} s  {text}", flush=True)

    def wait(self, what: str, condition: Callable[[], object], seconds: float = 90) -> object:
        """Waits until a condition holds; takes a picture and ends if it does not."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if found := condition():
                    self.say(what)
                    return found
            except WebDriverException:
                pass  # The page has changed meanwhile.
            time.sleep(0.2)
        self.picture("timeout")
        raise SystemExit(f"never: {what}")

    def picture(self, name: str) -> None:
        """Takes a screenshot."""
        time.sleep(0.5)
        self.browser.save_screenshot(str(self.out / f"{name}.png"))

    def all(self, selector: str) -> list[WebElement]:
        """The elements of the page for a selector."""
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector: str) -> str:
        """The texts of these elements."""
        return " ".join(element.text for element in self.all(selector)).replace("\u00a0", " ")

    def press(self, *keys: str) -> None:
        """Presses keys together."""
        actions = ActionChains(self.browser)
        for key in keys[:-1]:
            actions.key_down(key)
        actions.send_keys(keys[-1])
        for key in keys[:-1]:
            actions.key_up(key)
        actions.perform()

    def type(self, text: str) -> None:
        """Types into what is active."""
        ActionChains(self.browser).send_keys(text).perform()

    def choose(self, key: tuple[str, ...], text: str) -> None:
        """Types into the box that a key opens, and takes the first choice."""
        self.press(*key)
        self.wait("  " + text, lambda: self.all(".quick-input-widget input"))
        time.sleep(0.3)
        self.type(text)
        self.wait("  offered", lambda: text in self.text(".quick-input-list .monaco-list-row.focused"))
        self.press(Keys.ENTER)
        time.sleep(0.7)

    def run(self, command: str) -> None:
        """Runs a command of the palette."""
        self.choose((Keys.F1,), command)

    def edit(self, name: str) -> None:
        """Opens a file."""
        self.choose((Keys.CONTROL, "p"), name)
        self.wait(f"{name} is open", lambda: name in self.text(".tab.active"))
        self.wait(f"{name} is shown", lambda: self.all(".monaco-editor .view-line"))

    def inside(self, check: Callable[[], object]) -> object:
        """What a check finds inside a panel of the extension, which is a frame in a frame."""
        for outer in self.all("iframe.webview.ready"):
            try:
                self.browser.switch_to.frame(outer)
                self.browser.switch_to.frame(self.browser.find_element(By.ID, "active-frame"))
                if found := check():
                    return found
            except WebDriverException:
                pass  # It is being loaded.
            finally:
                self.browser.switch_to.default_content()
        return None


def colours(workbench: Workbench) -> None:
    """Templates and constraints are coloured."""
    for name in ("list.mtl", "rules.ocl"):
        workbench.edit(name)
        workbench.wait(
            f"colours of {name}",
            lambda: len(set(e.get_attribute("class") for e in workbench.all(".view-line span span"))) > 4,
        )
        workbench.picture(f"colours-{name}")


def snippets(workbench: Workbench) -> None:
    """A snippet is offered."""
    workbench.edit("new.mtl")
    workbench.type("templ")
    workbench.press(Keys.CONTROL, " ")
    workbench.wait("snippet", lambda: "template" in workbench.text(".suggest-widget"))
    workbench.picture("snippet")
    workbench.press(Keys.ESCAPE)
    workbench.run("File: Revert File")


def chain(workbench: Workbench) -> None:
    """The event chain is drawn, and a click leads to the component."""
    workbench.edit("requirements.md")
    workbench.run("Eventchain: Show Event Chain")
    workbench.wait("chain", lambda: workbench.inside(lambda: workbench.all('svg g[role="button"]')))
    workbench.picture("chain")

    def click() -> bool:
        for part in workbench.all('svg g[role="button"]'):
            if "Brake_Request" in (part.get_attribute("textContent") or ""):
                ActionChains(workbench.browser).click(part).perform()
                return True
        return False

    workbench.wait("clicked", lambda: workbench.inside(click))
    workbench.wait("component", lambda: "chain.xmi" in workbench.text(".tab.active"))
    workbench.wait("its place", lambda: "Ln 4" in workbench.text(".statusbar"))
    workbench.picture("chain-element")


def server(workbench: Workbench) -> None:
    """The language server finds, completes and explains."""
    workbench.edit("rules.ocl")
    workbench.press(Keys.CONTROL, Keys.END)
    workbench.type("  inv Named: self.nam <> null")
    workbench.wait("finding", lambda: workbench.all(".squiggly-error"))
    workbench.run("View: Focus Problems")
    workbench.wait("problems", lambda: "'nam'" in workbench.text(".markers-panel"))
    workbench.picture("server-finding")
    workbench.run("View: Focus Active Editor Group")
    workbench.press(Keys.CONTROL, Keys.END)
    for _ in "() <> null":
        workbench.press(Keys.ARROW_LEFT)
    workbench.press(Keys.ARROW_RIGHT)
    workbench.press(Keys.ARROW_RIGHT)
    workbench.run("Eventchain: Explain Finding")
    workbench.wait("its page", lambda: "Preview" in workbench.text(".tab.active"))
    workbench.picture("server-page")
    workbench.edit("rules.ocl")
    workbench.press(Keys.CONTROL, " ")
    workbench.wait("completion", lambda: "name" in workbench.text(".suggest-widget"))
    workbench.picture("server-completion")
    workbench.press(Keys.ENTER)
    workbench.wait("no finding", lambda: not workbench.all(".squiggly-error"))
    workbench.run("Show or Focus Hover")
    workbench.wait("hover", lambda: "String" in workbench.text(".monaco-hover"))
    workbench.picture("server-hover")
    workbench.press(Keys.ESCAPE)
    workbench.run("File: Revert File")


def tests(workbench: Workbench) -> None:
    """The test explorer runs scenarios and component tests; the one that fails says where."""
    workbench.run("Testing: Focus on Test Explorer View")
    workbench.wait(
        "tests",
        lambda: "Scenarios" in workbench.text(".test-explorer") or "workspace" in workbench.text(".test-explorer"),
    )
    workbench.run("Test: Run All Tests")
    workbench.wait("failed", lambda: workbench.all(".test-explorer .codicon-testing-failed-icon"), 240)
    workbench.picture("tests")
    workbench.edit("short-sight.yaml")
    workbench.wait(
        "its message",
        lambda: workbench.all(".test-error-content-widget, .test-message-inline-content, .testing-run-glyph"),
    )
    workbench.picture("tests-failure")


def report(workbench: Workbench) -> None:
    """The report is shown in a panel, with its scripts."""
    workbench.edit("requirements.md")
    workbench.run("View: Close All Editor Groups")
    workbench.edit("requirements.md")
    workbench.run("Eventchain: Show Report")
    workbench.wait(
        "report",
        lambda: workbench.inside(
            lambda: "stopped-vehicle" in workbench.text("body") or "Stopped vehicle" in workbench.text("body")
        ),
    )
    workbench.picture("report")


def workspace(folder: Path) -> None:
    """An example with a template, constraints, and a scenario that fails."""
    shutil.copytree(REPOSITORY / "examples/radar-aeb", folder, ignore=shutil.ignore_patterns("out"))
    (folder / "list.mtl").write_text(TEMPLATE)
    (folder / "new.mtl").write_text("[comment encoding = UTF-8 /]\n")
    (folder / "rules.ocl").write_text(CONSTRAINTS)
    scenario = folder / "scenarios/short-sight.yaml"
    text = scenario.read_text()
    scenario.write_text(text.replace("[5, 12] ego.speed <= 12", "[5, 6] ego.speed <= 2"))
    assert scenario.read_text() != text


def main() -> None:
    """Runs all checks, or those that are named."""
    code_server, vsix, out = (Path(argument).resolve() for argument in sys.argv[1:4])
    named = sys.argv[4:]
    shutil.rmtree(out, ignore_errors=True)
    workbench = Workbench(code_server, out)
    workspace(workbench.folder)
    workbench.install(vsix)
    try:
        workbench.open()
        for check in (colours, snippets, server, chain, tests, report):
            if not named or check.__name__ in named:
                check(workbench)
    finally:
        workbench.close()
    workbench.say("all is well")


if __name__ == "__main__":
    main()
