package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.diagnostics.Xml;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Test case of a JUnit report. It fails if it has an error. */
final class JunitCase {

  private final String name;
  private final List<Diagnostic> errors = new ArrayList<>();
  private final List<Diagnostic> others = new ArrayList<>();
  private final List<Suppressions.Suppressed> suppressed = new ArrayList<>();
  private boolean isCheck;
  private Optional<Trial> trial = Optional.empty();
  private long evaluations;

  JunitCase(String name) {
    this.name = name;
  }

  /** Adds to the number of evaluations of its check. */
  void evaluated(long times) {
    isCheck = true;
    evaluations += times;
  }

  /** Takes over the outcome of a test. */
  void tried(Trial tried) {
    trial = Optional.of(tried);
    tried.findings().forEach(this::found);
  }

  private boolean had(Trial.Outcome outcome) {
    return trial.filter(each -> each.outcome() == outcome).isPresent();
  }

  /** Returns the simulated time, in s. */
  double seconds() {
    return trial.map(Trial::seconds).orElse(0.0);
  }

  void found(Diagnostic finding) {
    (finding.severity() == Severity.ERROR ? errors : others).add(finding);
  }

  void suppressed(Suppressions.Suppressed finding) {
    suppressed.add(finding);
  }

  boolean failed() {
    return !errors.isEmpty() || had(Trial.Outcome.FAILED);
  }

  boolean skipped() {
    boolean idle = isCheck && evaluations == 0;
    boolean unjudged = had(Trial.Outcome.SKIPPED) || had(Trial.Outcome.UNTESTED);
    return !failed() && (idle || unjudged || !suppressed.isEmpty());
  }

  void write(String className, StringBuilder xml) {
    xml.append("    <testcase classname=\"").append(Xml.attribute(className));
    xml.append("\" name=\"").append(Xml.attribute(name)).append('"').append(time(seconds()));
    Optional<Trial.Evidence> evidence = trial.flatMap(Trial::evidence);
    evidence.ifPresent(each -> xml.append(JunitLinks.attributes(each.place(), !skipped())));
    String figures = trial.map(each -> JunitLinks.element(each.figures())).orElse("");
    String properties = evidence.map(JunitLinks::properties).orElse(figures);
    if (!failed() && !skipped() && output().isEmpty() && properties.isEmpty()) {
      xml.append("/>\n");
      return;
    }
    xml.append(">\n").append(properties);
    if (failed()) {
      xml.append("      <failure message=\"").append(Xml.attribute(headline()));
      xml.append("\" type=\"").append(Xml.attribute(type())).append("\">");
      xml.append(Xml.text(textOf(errors))).append("</failure>\n");
    } else if (skipped()) {
      xml.append("      <skipped message=\"").append(Xml.attribute(whySkipped())).append("\"/>\n");
    }
    if (!output().isEmpty()) {
      xml.append("      <system-out>").append(Xml.text(output())).append("</system-out>\n");
    }
    xml.append("    </testcase>\n");
  }

  /** Returns the attribute for a time in s, to the millisecond. */
  static String time(double seconds) {
    String number = seconds == 0 ? "0" : String.format(Locale.ROOT, "%.3f", seconds);
    return " time=\"" + number + '"';
  }

  /** Returns the measurements of a test that passed, and the findings that are no errors. */
  private String output() {
    String measured =
        trial
            .filter(each -> each.outcome() == Trial.Outcome.PASSED && !each.text().isEmpty())
            .map(each -> each.text() + "\n")
            .orElse("");
    return measured + textOf(others);
  }

  private String type() {
    return errors.isEmpty() ? "not passed" : errors.get(0).id();
  }

  private String headline() {
    if (errors.isEmpty()) {
      return trial.map(Trial::text).orElse("");
    }
    String first = errors.get(0).message();
    return errors.size() == 1 ? first : errors.size() + " findings; the first: " + first;
  }

  private String whySkipped() {
    if (suppressed.isEmpty() && trial.isPresent()) {
      return trial.get().text();
    }
    if (suppressed.isEmpty()) {
      return "The model has nothing that it applies to.";
    }
    List<String> reasons =
        suppressed.stream()
            .map(each -> each.by().reason() + " (until " + each.by().expires() + ")")
            .distinct()
            .toList();
    return suppressed.size() + " suppressed: " + String.join("; ", reasons);
  }

  private static String textOf(List<Diagnostic> findings) {
    StringBuilder text = new StringBuilder();
    findings.forEach(finding -> TextReport.append(finding, text));
    return text.toString();
  }
}
