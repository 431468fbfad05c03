// From requirements to the files made for them and to what proves them.

const MOST_PROOFS = 4;

/** The row of a requirement: the model's, or a new one for what the model does not know. */
function requirementRow(requirement, index, body) {
  const name = text(requirement.id);
  const known = [...body.rows].find((row) => row.dataset.requirement === name);
  if (known) {
    return known;
  }
  const row = body.insertRow();
  fill(row, { role: "row", "data-requirement": name }, [
    html("th", { scope: "row", role: "rowheader" }, html("span", { id: "rule-" + (index + 1) }, name), html("div", { class: "statement" }, text(requirement.text))),
    ["Components", "Files", "Proved by"].map((label) => html("td", { role: "cell", "data-label": label }))]);
  row.cells[1].append(codes(requirement.components));
  return row;
}

function requirementLink(name) {
  const row = [...document.querySelectorAll("tr[data-requirement]")].find((one) => one.dataset.requirement === name);
  return row ? html("a", { href: "#" + row.querySelector("[id]").id }, name) : name;
}

/** A link to a file beside this page, whatever its name says. */
function fileLink(name, shown) {
  return html("a", { href: "./" + name.split("/").map(encodeURIComponent).join("/") }, code(shown));
}

function rangeText(first, last) {
  return first === last ? whole(first) : `${whole(first)}\u2013${whole(last)}`;
}

/** Lines one after the other become one range. */
function rangesOf(lines) {
  const ranges = [];
  for (const line of lines) {
    const last = ranges[ranges.length - 1];
    if (last && number(line.first) <= last.last + 1) {
      last.last = Math.max(last.last, number(line.last));
    } else {
      ranges.push({ first: number(line.first), last: number(line.last) });
    }
  }
  return ranges;
}

/** The lines of a generated file that a component made, and the line of the template behind each. */
function generatedLines(file) {
  const lines = records(file.lines).filter((line) => number(line.first) !== null && number(line.last) !== null);
  const ranges = rangesOf(lines).map((range) => rangeText(range.first, range.last)).join(", ");
  const title = `${count(lines.reduce((sum, line) => sum + line.last - line.first + 1, 0), "line")} for ${text(file.node)}`;
  return html("details", { title }, html("summary", { class: "small" }, `${/^\d+$/.test(ranges) ? "line" : "lines"} ${ranges}`),
    html("ol", { class: "small lines" }, lines.map((line) => html("li", null, html("span", { class: "muted" }, rangeText(line.first, line.last) + " "), code(text(line.from))))));
}

/** The files generated for a requirement, each once. */
function generatedFiles(generated) {
  const names = [...new Set(generated.map((file) => text(file.file)))];
  return names.length === 0 ? null : html("details", { class: "small" }, html("summary", null, count(names.length, "generated file")),
    html("ul", null, names.map((name) => html("li", { class: "generated" }, fileLink(name, name), generated.filter((file) => text(file.file) === name).map(generatedLines)))));
}

function proofItem(proof) {
  const scenario = text(proof.kind) === "scenario" ? scenarios.find((one) => text(one.name) === text(proof.name)) : null;
  const { tone, word } = outcomeOf(proof);
  const passed = tone === "good";
  const name = scenario ? html("a", { href: "#" + scenarioId(scenario) }, titleOf(scenario)) : code(text(proof.name));
  const kind = scenario ? "" : text(proof.kind);
  return html("li", { class: "proof" }, sign(tone), html("span", null, passed ? unseen("passed: ") : null, name,
    html("span", { class: "small muted" }, kind ? " " + kind : ""), passed ? null : html("strong", { class: tone }, " " + word)));
}

/** What proves a requirement: a few, first of what does not pass, and how much is left of both. */
function proofList(proofs) {
  const bad = proofs.filter((proof) => proof.passed !== true);
  const good = proofs.filter((proof) => proof.passed === true);
  const shown = bad.length + good.length <= MOST_PROOFS ? [...bad, ...good] : bad.slice(0, MOST_PROOFS);
  const rest = [...bad, ...good].filter((proof) => !shown.includes(proof));
  const failed = rest.filter((proof) => proof.passed !== true).length;
  const words = [failed > 0 ? `${whole(failed)} more not passed` : "", rest.length > failed ? `${whole(rest.length - failed)} passed` : ""].filter(Boolean).join(", ");
  return [html("ul", null, shown.map(proofItem)),
    rest.length === 0 ? null : html("details", { class: "small" }, html("summary", null, words), html("ul", null, rest.map(proofItem)))];
}

/** The number of standard faults that the criteria of a requirement notice, and which they do not. */
function strengthItem(strength) {
  const noticed = number(strength?.noticed);
  if (noticed === null) {
    return null;
  }
  const all = number(strength.sampleOf);
  const words = `Notices ${noticed} of ${count(number(strength.faults), "fault")}${all === null ? "" : `, a sample of ${all}`}`;
  const missed = records(strength.unnoticed).map((one) => html("li", null, text(one.fault),
    one.nearest ? html("span", { class: "muted" }, `; nearest: ${text(one.nearest.criterion)} in ${text(one.nearest.scenario)}`) : null));
  const bound = boundItem(strength.bound);
  return missed.length === 0 ? html("div", { class: "small" }, html("p", null, words), bound)
    : html("details", { class: "small" }, html("summary", null, words), bound, html("p", null, "Not noticed:"), html("ul", null, missed));
}

/** The components that count for the part of the faults that the project asks for. */
function boundItem(bound) {
  const faults = number(bound?.faults);
  if (faults === null) {
    return null;
  }
  const names = list(bound.components).map(text).flatMap((name, index) => [index > 0 ? " and " : "", code(name)]);
  const percent = number(bound.minimumPercent);
  const all = number(bound.sampleOf);
  const least = `the bound of ${figure(percent, Number.isInteger(percent) ? 0 : 1)} %`;
  return html("p", null, faults === 0 ? ["No fault of ", names, ` counts for ${least}.`]
    : [`Compared with ${least}: ${whole(number(bound.noticed))} of ${count(faults, "fault")} of `, names, all === null ? "." : `, a sample of ${whole(all)}.`]);
}

/** Where a requirement is written, and what it is derived from. */
function originOf(requirement) {
  const parents = list(requirement.parents).map(text).flatMap((name, index) => [index > 0 ? ", " : "derived from ", requirementLink(name)]);
  return html("div", { class: "small muted" }, code(text(requirement.source)), parents.length > 0 ? [", ", ...parents] : null);
}

/** Adds files and proofs to the requirements of the model, and the design rules, which it does not hold. */
function completeRequirements() {
  const all = document.getElementById("requirements");
  const body = all.querySelector("tbody");
  requirements.forEach((requirement, index) => {
    const row = requirementRow(requirement, index, body);
    const proved = requirement.proved === true;
    const proofs = records(requirement.proofs);
    row.classList.toggle("unproved", !proved);
    if (requirement.source) {
      row.cells[0].append(originOf(requirement));
    }
    row.cells[2].append(html("ul", null, list(requirement.files).map((file) => html("li", null, code(file)))), ...[generatedFiles(records(requirement.generated))].filter(Boolean));
    row.cells[3].append(...[proved ? null : status("warn", proofs.length === 0 ? "Not proved: nothing tests it" : "Not proved"),
      ...proofList(proofs), strengthItem(requirement.strength)].filter(Boolean));
  });
  all.hidden = body.rows.length === 0;
  if (unproved.length > 0) {
    body.closest("table").before(html("p", { class: "notice" },
      html("strong", null, `Not proved: ${count(unproved.length, "requirement")}. `),
      unproved.flatMap((requirement, index) => [index > 0 ? ", " : "", requirementLink(text(requirement.id))])));
  }
}
