package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.RulePage;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Rules of a SARIF run: one for each diagnostic id, with one for each user rule below it ({@code
 * ocl.violated/SoftwareNode::Name}). Viewers group by rule and show its help.
 */
final class SarifRules {

  private final Map<String, Rule> rules = new LinkedHashMap<>();

  private record Rule(
      int index, String id, String name, Severity severity, SourceLocation location, String hint) {}

  SarifRules(Report report) {
    for (Coverage.Check check : report.coverage().checks()) {
      add(check.id(), check.rule(), check.severity(), check.location(), check.hint());
    }
    report.diagnostics().forEach(this::add);
    report.suppressed().forEach(suppressed -> add(suppressed.finding()));
  }

  private void add(Diagnostic finding) {
    String hint = finding.rule().isEmpty() ? "" : finding.hint();
    add(finding.id(), finding.rule(), finding.severity(), SourceLocation.NONE, hint);
  }

  private void add(
      String id, String name, Severity severity, SourceLocation location, String hint) {
    rules.computeIfAbsent(
        key(id, name), key -> new Rule(rules.size(), id, name, severity, location, hint));
  }

  /**
   * Returns the SARIF id of a rule. A slash separates the levels of an id, so names must not
   * contain it.
   */
  static String key(String id, String rule) {
    return rule.isEmpty() ? id : id + "/" + Printable.clean(rule).replace("/", "%2F");
  }

  int index(Diagnostic finding) {
    return rules.get(key(finding.id(), finding.rule())).index();
  }

  void write(JsonText json) throws IOException {
    for (Map.Entry<String, Rule> entry : rules.entrySet()) {
      json.object(members -> write(entry.getKey(), entry.getValue(), members));
    }
  }

  private static void write(String key, Rule rule, JsonText json) throws IOException {
    Optional<RulePage> page = RulePage.of(rule.id());
    String meaning = page.map(RulePage::firstSentence).orElse(rule.id());
    String title = rule.name().isEmpty() ? meaning : Printable.clean(rule.name());
    String help = help(rule, page.map(RulePage::text).orElse(""));
    json.text("id", key);
    json.textIfKnown("name", friendlyName(rule));
    json.object("shortDescription", text -> text.text("text", sentence(title)));
    json.object("fullDescription", text -> text.text("text", sentence(meaning)));
    json.object(
        "help",
        text -> {
          text.text("text", help);
          text.text("markdown", help);
        });
    json.object(
        "defaultConfiguration",
        configuration -> configuration.text("level", level(rule.severity())));
  }

  /**
   * Returns the name of a rule as a word in Pascal case, as viewers show it; empty if it contains
   * other characters.
   */
  private static String friendlyName(Rule rule) {
    String source = rule.name().isEmpty() ? rule.id() : rule.name().replaceFirst(".*::", "");
    StringBuilder name = new StringBuilder();
    for (String word : source.split("[.-]", -1)) {
      name.append(word.isEmpty() ? "" : Character.toUpperCase(word.charAt(0)) + word.substring(1));
    }
    return name.toString().matches("[A-Z][A-Za-z0-9]*") ? name.toString() : "";
  }

  /**
   * Returns the help: first the hint and the location of a user rule, then the page about its id.
   */
  private static String help(Rule rule, String page) {
    StringBuilder help = new StringBuilder();
    if (!rule.hint().isEmpty()) {
      help.append(Printable.clean(rule.hint())).append("\n\n");
    }
    if (!rule.location().file().isEmpty()) {
      help.append("The rule is in ")
          .append(Printable.clean(rule.location().toString()))
          .append(".\n\n");
    }
    String text = help.append(page).toString().strip();
    return text.isEmpty() ? rule.id() : text;
  }

  private static String sentence(String text) {
    return text.matches("(?s).*[.!?]") ? text : text + ".";
  }

  static String level(Severity severity) {
    return severity == Severity.INFO ? "note" : severity.toString();
  }
}
