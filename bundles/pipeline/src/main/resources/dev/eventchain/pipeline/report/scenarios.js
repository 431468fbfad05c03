// The scenarios: a list to choose from, and a card with criteria, figures and plots for each.

function scenarioFacts(scenario) {
  const impact = number(scenario.impactSpeed);
  const facts = [
    scenario.passed === true ? null : outcomeOf(scenario).word,
    impact !== null ? `impact ${figure(impact * 3.6, 1, "km/h")}` : number(scenario.minimalGap) !== null ? `gap ${figure(scenario.minimalGap, 1, "m")}` : null,
    list(record(scenario.series).brake).some((value) => value > 0) ? null : list(record(scenario.series).brake).length ? "never brakes" : null,
    number(record(scenario.latency).maximum) !== null ? latency(scenario.latency.maximum) : null,
  ];
  return facts.filter(Boolean).join(" \u00b7 ");
}

function scenarioTab(scenario) {
  const { tone } = outcomeOf(scenario);
  const id = scenarioId(scenario);
  return html("button", { type: "button", role: "tab", id: id + "-tab", "aria-controls": id, "aria-selected": "false", tabindex: -1 },
    sign(tone), html("span", null, scenario.passed === true ? unseen("passed: ") : null,
      html("span", { class: "name" }, titleOf(scenario)), html("span", { class: "facts" }, scenarioFacts(scenario))));
}

function criterionItem(criterion) {
  const { tone, word } = outcomeOf(criterion);
  const said = { passed: "met: ", failed: "not met: " }[word] ?? word + ": ";
  const measured = (tone === "warn" ? word + ": " : "") + text(criterion.measured);
  return html("li", null, sign(tone), html("span", null, unseen(said), text(criterion.text)),
    html("span", { class: "measured" + (tone === "good" ? "" : " " + tone) }, measured));
}

function scenarioCard(scenario) {
  const { tone, word } = outcomeOf(scenario);
  const id = scenarioId(scenario);
  const plots = plotsOf(scenario);
  const measured = record(scenario.latency);
  const impact = number(scenario.impactSpeed);
  const about = [code(text(scenario.name)), ...list(scenario.requirements).map((name) => requirementLink(text(name)))];
  const card = html("article", { class: "card", id, role: "tabpanel", "aria-labelledby": id + "-tab" },
    html("header", null, html("h3", null, titleOf(scenario)), status(tone, word[0].toUpperCase() + word.slice(1))),
    html("p", { class: "about" }, about.flatMap((part, index) => (index > 0 ? [" \u00b7 ", part] : [part]))),
    html("ul", { class: "criteria", "aria-label": "Criteria" }, records(scenario.criteria).map(criterionItem)),
    figures("figures", [
      ["Smallest gap", number(scenario.minimalGap) === null ? null : figure(scenario.minimalGap, 2, "m")],
      ["Impact", impact === null ? null : figure(impact * 3.6, 1, "km/h")],
      ["TTC at first braking", number(scenario.timeToCollisionAtFirstBraking) === null ? null : figure(scenario.timeToCollisionAtFirstBraking, 2, "s")],
      ["Brake command after scan", number(measured.median) === null ? null : latency(measured.median), `median, at most ${latency(measured.maximum)}`],
    ]),
    plots.element);
  return { card, draw: plots.draw };
}

function scenarioSection() {
  if (scenarios.length === 0) {
    return null;
  }
  const tabs = scenarios.map(scenarioTab);
  const cards = scenarios.map(scenarioCard);
  const choose = (index, { focus = false, scroll = false } = {}) => {
    tabs.forEach((tab, at) => {
      tab.setAttribute("aria-selected", String(at === index));
      tab.tabIndex = at === index ? 0 : -1;
      cards[at].card.hidden = at !== index;
    });
    cards[index].draw();
    showInList(tabs[index]);
    if (focus) {
      tabs[index].focus({ preventScroll: true });
    }
    if (scroll) {
      document.getElementById("scenarios").scrollIntoView();
    }
  };
  const tablist = html("div", { class: "list", role: "tablist", "aria-orientation": "vertical", "aria-label": "Scenarios" }, tabs);
  tabs.forEach((tab, index) => tab.addEventListener("click", () => choose(index, { focus: true })));
  tablist.addEventListener("keydown", (event) => moveInList(event, tabs, choose));
  const byHash = () => {
    const index = scenarios.findIndex((scenario) => "#" + scenarioId(scenario) === location.hash);
    if (index >= 0) {
      choose(index, { scroll: true });
    }
  };
  addEventListener("hashchange", byHash);
  addEventListener("beforeprint", () => cards.forEach((entry) => entry.draw()));
  whenShown.push(() => choose(Math.max(0, scenarios.indexOf(failedScenarios[0]))), byHash);
  return section("scenarios", "Scenarios",
    "Move over the plots, or use the slider, to read the values at a time.",
    html("div", { class: "scenarios" + (scenarios.length === 1 ? " single" : "") }, tablist, html("div", null, cards.map((entry) => entry.card))));
}

/** Scrolls the list, and only the list, to a tab. */
function showInList(tab) {
  const tablist = tab.parentElement;
  const below = tab.offsetTop + tab.offsetHeight - tablist.clientHeight;
  tablist.scrollTop = Math.min(tab.offsetTop, Math.max(tablist.scrollTop, below));
}

function moveInList(event, tabs, choose) {
  const at = tabs.indexOf(document.activeElement);
  const targets = { ArrowDown: at + 1, ArrowRight: at + 1, ArrowUp: at - 1, ArrowLeft: at - 1, Home: 0, End: tabs.length - 1 };
  if (at >= 0 && Object.hasOwn(targets, event.key)) {
    event.preventDefault();
    choose((targets[event.key] + tabs.length) % tabs.length, { focus: true });
  }
}
