package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import java.io.IOException;

/** Report as JSON, in this program's own format with all data. */
final class JsonReport {

  private final Report report;

  private JsonReport(Report report) {
    this.report = report;
  }

  static String render(Report report) {
    return JsonText.document(new JsonReport(report)::write);
  }

  private void write(JsonText json) throws IOException {
    json.object(
        "tool",
        tool -> {
          tool.text("name", "eventchain");
          tool.textIfKnown("version", report.version());
        });
    json.number("exitCode", report.exitCode());
    json.object("summary", this::summary);
    json.array(
        "files",
        files -> {
          for (String file : report.coverage().files()) {
            files.text(file);
          }
        });
    json.array("checks", this::checks);
    json.array(
        "findings",
        findings -> {
          for (Diagnostic finding : report.diagnostics()) {
            findings.object(members -> finding(finding, members));
          }
        });
    json.array("suppressed", this::suppressed);
  }

  private void summary(JsonText json) throws IOException {
    Coverage coverage = report.coverage();
    json.number("files", coverage.files().size());
    json.number("elements", coverage.elements());
    json.number("constraints", coverage.constraints());
    json.number("evaluations", coverage.evaluations(Coverage.Kind.CONSTRAINT));
    json.number("contracts", coverage.evaluations(Coverage.Kind.CONTRACT));
    json.number("metamodelChecks", coverage.evaluations(Coverage.Kind.METAMODEL));
    json.number("errors", report.count(Severity.ERROR));
    json.number("warnings", report.count(Severity.WARNING));
    json.number("infos", report.count(Severity.INFO));
    json.number("suppressed", report.suppressed().size());
  }

  private void checks(JsonText json) throws IOException {
    for (Coverage.Check check : report.coverage().checks()) {
      json.object(
          members -> {
            members.text("id", check.id());
            members.textIfKnown("rule", check.rule());
            members.text("severity", check.severity().toString());
            place(check.location(), members);
            members.number("evaluations", check.evaluations());
          });
    }
  }

  private void suppressed(JsonText json) throws IOException {
    for (Suppressions.Suppressed suppressed : report.suppressed()) {
      json.object(
          members -> {
            finding(suppressed.finding(), members);
            members.text("reason", suppressed.by().reason());
            members.text("expires", suppressed.by().expires().toString());
          });
    }
  }

  private static void finding(Diagnostic finding, JsonText json) throws IOException {
    json.text("id", finding.id());
    json.text("severity", finding.severity().toString());
    json.text("message", finding.message());
    place(finding.location(), json);
    json.textIfKnown("hint", finding.hint());
    json.textIfKnown("rule", finding.rule());
    if (!finding.related().isEmpty()) {
      json.array(
          "related",
          places -> {
            for (SourceLocation related : finding.related()) {
              places.object(members -> place(related, members));
            }
          });
    }
    if (finding.cause().isPresent()) {
      json.object("cause", members -> place(finding.cause().get().location(), members));
    }
  }

  private static void place(SourceLocation location, JsonText json) throws IOException {
    json.textIfKnown("file", location.file());
    json.numberIfKnown("line", location.line());
    json.numberIfKnown("column", location.column());
    json.textIfKnown("element", location.element());
  }
}
