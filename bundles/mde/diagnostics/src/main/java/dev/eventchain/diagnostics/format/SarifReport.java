package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Sha256;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Report as SARIF 2.1.0, independent of machine, time and run, except for the names of files
 * outside the working folder. Numbers in comments are sections of the standard.
 */
final class SarifReport {

  private static final String SCHEMA =
      "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";
  private static final int FINGERPRINT_DIGITS = 32;

  private final Report report;
  private final SarifRules rules;
  private final Map<String, Integer> seen = new HashMap<>();

  private SarifReport(Report report) {
    this.report = report;
    this.rules = new SarifRules(report);
  }

  static String render(Report report) {
    SarifReport sarif = new SarifReport(report);
    return JsonText.document(
        json -> {
          json.text("$schema", SCHEMA);
          json.text("version", "2.1.0");
          json.array("runs", runs -> runs.object(sarif::run));
        });
  }

  private void run(JsonText json) throws IOException {
    json.object("tool", tool -> tool.object("driver", this::driver));
    json.array("invocations", all -> all.object(this::invocation));
    json.object(
        "originalUriBaseIds",
        bases ->
            bases.object(
                SarifPlaces.BASE,
                base ->
                    base.object(
                        "description",
                        text -> text.text("text", "The folder that the program was started in."))));
    json.array("artifacts", this::artifacts);
    json.array("results", this::results);
    json.text("columnKind", "utf16CodeUnits");
    json.object("properties", this::counters);
  }

  private void driver(JsonText json) throws IOException {
    json.text("name", "eventchain");
    json.textIfKnown("version", report.version());
    json.array("rules", rules::write);
  }

  private void invocation(JsonText json) throws IOException {
    json.truth("executionSuccessful", report.successful());
    json.number("exitCode", report.exitCode());
  }

  private void artifacts(JsonText json) throws IOException {
    for (String file : report.coverage().files()) {
      json.object(
          members -> {
            members.object("location", location -> SarifPlaces.artifact(file, location));
            members.array("roles", roles -> roles.text("analysisTarget"));
          });
    }
  }

  private void counters(JsonText json) throws IOException {
    Coverage coverage = report.coverage();
    json.number("elements", coverage.elements());
    json.number("constraints", coverage.constraints());
    json.number("evaluations", coverage.evaluations(Coverage.Kind.CONSTRAINT));
    json.number("contracts", coverage.evaluations(Coverage.Kind.CONTRACT));
    json.number("metamodelChecks", coverage.evaluations(Coverage.Kind.METAMODEL));
  }

  private void results(JsonText json) throws IOException {
    for (Diagnostic finding : report.diagnostics()) {
      json.object(
          members -> {
            result(finding, members);
            if (!report.suppressed().isEmpty()) {
              // 3.27.23: if a run has suppressions, every result states whether it is
              // suppressed.
              members.array("suppressions", none -> {});
            }
          });
    }
    for (Suppressions.Suppressed suppressed : report.suppressed()) {
      json.object(
          members -> {
            result(suppressed.finding(), members);
            members.array(
                "suppressions", all -> all.object(one -> suppression(suppressed.by(), one)));
          });
    }
  }

  private static void suppression(Suppressions.Entry entry, JsonText json) throws IOException {
    json.text("kind", "external");
    json.text("status", "accepted");
    json.text(
        "justification", Printable.clean(entry.reason()) + " (until " + entry.expires() + ")");
    json.object("location", location -> SarifPlaces.location(entry.location(), location));
  }

  private void result(Diagnostic finding, JsonText json) throws IOException {
    json.text("ruleId", SarifRules.key(finding.id(), finding.rule()));
    json.number("ruleIndex", rules.index(finding));
    json.text("level", SarifRules.level(finding.severity()));
    json.object("message", message -> message.text("text", message(finding)));
    SourceLocation place = placeOf(finding);
    if (!place.equals(SourceLocation.NONE)) {
      json.array("locations", all -> all.object(location -> SarifPlaces.location(place, location)));
    }
    if (!finding.related().isEmpty()) {
      json.array("relatedLocations", all -> related(finding.related(), all));
    }
    json.object(
        "partialFingerprints", all -> all.text("eventchainFinding/v1", fingerprint(finding)));
  }

  /**
   * Returns the message with escaped brackets, because brackets before a parenthesis would form a
   * link (3.11.6).
   */
  private static String message(Diagnostic finding) {
    String hint = finding.hint().isEmpty() ? "" : " " + finding.hint();
    String text = Printable.clean(finding.message() + hint);
    return text.contains("](")
        ? text.replace("\\", "\\\\").replace("[", "\\[").replace("]", "\\]")
        : text;
  }

  /**
   * Returns the location of a finding. One without a file gets the first file, because viewers drop
   * results without a file.
   */
  private SourceLocation placeOf(Diagnostic finding) {
    List<String> files = report.coverage().files();
    SourceLocation place = finding.location();
    return place.file().isEmpty() && !files.isEmpty()
        ? SourceLocation.of(files.get(0)).withElement(place.element())
        : place;
  }

  private static void related(List<SourceLocation> places, JsonText json) throws IOException {
    int id = 1;
    for (SourceLocation place : places) {
      int number = id++;
      json.object(
          location -> {
            location.number("id", number);
            SarifPlaces.location(place, location);
          });
    }
  }

  /**
   * Returns a fingerprint that is stable when lines move: of the rule and the element, or else the
   * source line.
   */
  private String fingerprint(Diagnostic finding) {
    SourceLocation place = finding.location();
    String where = place.element().isEmpty() ? place.excerpt().strip() : place.element();
    String what = where.isEmpty() ? finding.message() : where;
    String text =
        String.join(
            "\n", finding.id(), finding.rule(), SarifPlaces.fingerprintOf(place.file()), what);
    String hex = Sha256.of(text).hex().substring(0, FINGERPRINT_DIGITS);
    return hex + ":" + seen.merge(hex, 1, Integer::sum);
  }
}
