// What language models were asked, what they answered, and why answers went back.

function exchangeItem(exchange, index, all) {
  const findings = records(exchange.findings).filter((finding) => severityOf(finding) === "ERROR");
  const tokens = number(exchange.outputTokens) === null ? "" : `, ${whole(exchange.inputTokens)} + ${whole(exchange.outputTokens)} tokens`;
  const words = findings.length > 0 ? status("warn", "Went back") : status("good", index < all.length - 1 ? "Accepted, asked again later" : "Accepted");
  return html("li", null,
    html("p", { class: "small" }, words, html("span", { class: "muted" }, ` ${text(exchange.model)}, ${text(exchange.provenance)}${tokens}`)),
    spoken("Question", exchange.question), spoken("Answer", exchange.answer),
    findings.length === 0 ? null : html("ul", { class: "small" }, findings.map((finding) => html("li", null, text(finding.message), " ", code(text(finding.id))))));
}

function spoken(kind, words) {
  const lines = text(words).trimEnd().split("\n").length;
  return html("details", null, html("summary", { class: "small" }, `${kind}, ${count(lines, "line")}`), html("pre", { class: "spoken" }, text(words).trimEnd()));
}

/** The conversations, by the file that each was to give, in the order in which they began. */
function conversationSection() {
  const exchanges = records(data.conversations);
  if (exchanges.length === 0) {
    return null;
  }
  const files = [...new Set(exchanges.map((exchange) => text(exchange.file)))];
  const returned = exchanges.filter((exchange) => records(exchange.findings).some((finding) => severityOf(finding) === "ERROR")).length;
  return section("conversations", "Language models", `${count(exchanges.length, "answer")}, of which ${whole(returned)} went back with what was wrong.`,
    files.map((file) => {
      const all = exchanges.filter((exchange) => text(exchange.file) === file);
      return html("details", { class: "conversation" }, html("summary", null, code(file), html("span", { class: "muted" }, ` ${count(all.length, "answer")}`)),
        html("ol", null, all.map(exchangeItem)));
    }));
}
