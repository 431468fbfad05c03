// The scenarios: a list to choose from, and a card with criteria, figures and plots for each.

function scenarioFacts(scenario) {
  const criteria = records(scenario.criteria);
  const missed = criteria.filter((criterion) => outcomeOf(criterion).tone === "bad");
  const facts = [
    scenario.passed === true ? null : outcomeOf(scenario).word,
    criteria.length === 0 ? null : missed.length > 0 ? `${missed.length} of ${count(criteria.length, "criterion", "criteria")} missed` : count(criteria.length, "criterion", "criteria"),
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

/** What another run had of a criterion, where that differs. */
function beforeOf(criterion, before) {
  const earlier = records(record(before).criteria).find((each) => text(each.text) === text(criterion.text));
  if (!earlier) {
    return records(record(before).criteria).length > 0 ? html("span", { class: "margin" }, "not there before") : null;
  }
  const same = text(earlier.measured) === text(criterion.measured) && outcomeOf(earlier).word === outcomeOf(criterion).word;
  return same ? null : html("span", { class: "margin" }, `before: ${outcomeOf(earlier).word}, ${text(earlier.measured)}`);
}

/** What was reported without being judged. */
function observedList(observed) {
  if (observed.length === 0) {
    return null;
  }
  const item = (each) => html("li", null, html("span", null, text(each.text)), html("span", { class: "measured" }, `${outcomeOf(each).word}: ${text(each.measured)}`));
  return html("details", { class: "observed" }, html("summary", null, `Observed, not judged: ${observed.length}`), html("ul", { class: "criteria" }, observed.map(item)));
}

/** The words of requirements that a criterion judges. */
function judgedWords(criterion) {
  return records(criterion.judges).map((each) => html("span", { class: "judged" }, text(each.requirement) + " ", html("q", null, text(each.words))));
}

function criterionItem(criterion, before) {
  const { tone, word } = outcomeOf(criterion);
  const said = { passed: "met: ", failed: "not met: " }[word] ?? word + ": ";
  const measured = (tone === "warn" ? word + ": " : "") + text(criterion.measured);
  return html("li", null, sign(tone), html("span", null, unseen(said), text(criterion.text), judgedWords(criterion)),
    html("span", { class: "measured" + (tone === "good" ? "" : " " + tone) }, measured, marginOf(record(criterion.margin)), beforeOf(criterion, before)));
}

/** What ended a run before all criteria were decided. */
function impactOf(scenario) {
  return eventsOf(scenario).some((each) => text(each.name) === "impact.speed") ? "the impact" : "its duration or a trigger";
}

/** The criteria; those that are consequences of what ended the run are folded. */
function criteriaLists(scenario) {
  const all = records(scenario.criteria);
  const left = all.filter((criterion) => criterion.consequence === true);
  const items = (some) => some.map((criterion) => criterionItem(criterion, scenario.before));
  return [html("ul", { class: "criteria", "aria-label": "Criteria" }, items(all.filter((criterion) => !left.includes(criterion)))),
    left.length === 0 ? null : html("details", { class: "observed" },
      html("summary", null, `Consequences of ${impactOf(scenario)}, which ended the run: ${count(left.length, "criterion", "criteria")}`),
      html("ul", { class: "criteria" }, items(left)))];
}

/** How far it is from the other verdict, in its own unit, and when. */
function marginOf(margin) {
  if (number(margin.value) === null) {
    return null;
  }
  const when = number(margin.time) === null ? "" : ` after ${figure(margin.time, 2, "s")}`;
  return html("span", { class: "margin" }, `margin ${amount(margin.value, margin.unit)}${when}`);
}

/** A number with its unit, which is left out where it is a ratio. */
function amount(value, unit) {
  const size = Math.abs(number(value) ?? 0);
  return figure(value, size >= 100 ? 1 : size >= 1 || size === 0 ? 2 : 3, text(unit) === "1" ? "" : text(unit));
}

/** What was measured of each quantity: its smallest and its largest value, and when. */
function measuredTable(scenario) {
  const all = records(scenario.measurements);
  const names = [...new Set(all.map((one) => text(one.name)))];
  const cell = (name, statistic) => {
    const one = all.find((each) => text(each.name) === name && text(each.statistic) === statistic);
    return one ? [amount(one.value, one.unit), html("span", { class: "muted small" }, ` after ${figure(one.time, 2, "s")}`)] : "";
  };
  const columns = [{ name: "Quantity", row: true }, { name: "Smallest", number: true }, { name: "Largest", number: true }, { name: "At the end", number: true }];
  return names.length === 0 ? null : html("details", { class: "quantities" }, html("summary", null, "Quantities"),
    table("Quantities of the scenario", columns, names.map((name) => ({ cells: [code(name), cell(name, "MINIMUM"), cell(name, "MAXIMUM"), cell(name, "FINAL")] }))));
}

function scenarioCard(scenario) {
  const { tone, word } = outcomeOf(scenario);
  const id = scenarioId(scenario);
  const plots = plotsOf(scenario);
  const measured = record(scenario.latency);
  const about = [code(text(scenario.name)), ...list(scenario.requirements).map((name) => requirementLink(text(name))),
    ...(number(measured.median) === null ? [] : [`latency of the chain: median ${latency(measured.median)}, at most ${latency(measured.maximum)}`])];
  const card = html("article", { class: "card", id, role: "tabpanel", "aria-labelledby": id + "-tab" },
    html("header", null, html("h3", null, titleOf(scenario)), status(tone, word[0].toUpperCase() + word.slice(1))),
    html("p", { class: "about" }, about.flatMap((part, index) => (index > 0 ? [" \u00b7 ", part] : [part]))),
    criteriaLists(scenario),
    observedList(records(scenario.observed)),
    plots.element, measuredTable(scenario));
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
