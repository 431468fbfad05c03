package dev.eventchain.diagnostics;

import java.util.ArrayList;
import java.util.List;

/** Test case of a JUnit report. It fails if it has an error. */
final class JunitCase {

  private final String name;
  private final List<Diagnostic> errors = new ArrayList<>();
  private final List<Diagnostic> others = new ArrayList<>();
  private final List<Suppressions.Suppressed> suppressed = new ArrayList<>();
  private boolean isCheck;
  private long evaluations;

  JunitCase(String name) {
    this.name = name;
  }

  /** Adds to the number of evaluations of its check. */
  void evaluated(long times) {
    isCheck = true;
    evaluations += times;
  }

  void found(Diagnostic finding) {
    (finding.severity() == Severity.ERROR ? errors : others).add(finding);
  }

  void suppressed(Suppressions.Suppressed finding) {
    suppressed.add(finding);
  }

  boolean failed() {
    return !errors.isEmpty();
  }

  boolean skipped() {
    return !failed() && ((isCheck && evaluations == 0) || !suppressed.isEmpty());
  }

  void write(String className, StringBuilder xml) {
    xml.append("    <testcase classname=\"").append(Xml.attribute(className));
    xml.append("\" name=\"").append(Xml.attribute(name)).append("\" time=\"0\"");
    if (!failed() && !skipped() && others.isEmpty()) {
      xml.append("/>\n");
      return;
    }
    xml.append(">\n");
    if (failed()) {
      xml.append("      <failure message=\"").append(Xml.attribute(headline()));
      xml.append("\" type=\"").append(Xml.attribute(errors.get(0).id())).append("\">");
      xml.append(Xml.text(textOf(errors))).append("</failure>\n");
    } else if (skipped()) {
      xml.append("      <skipped message=\"").append(Xml.attribute(whySkipped())).append("\"/>\n");
    }
    if (!others.isEmpty()) {
      xml.append("      <system-out>").append(Xml.text(textOf(others))).append("</system-out>\n");
    }
    xml.append("    </testcase>\n");
  }

  private String headline() {
    String first = errors.get(0).message();
    return errors.size() == 1 ? first : errors.size() + " findings; the first: " + first;
  }

  private String whySkipped() {
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
