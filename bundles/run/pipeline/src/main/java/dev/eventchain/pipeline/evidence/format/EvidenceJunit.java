package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.diagnostics.Xml;
import dev.eventchain.diagnostics.format.JunitLinks;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * JUnit XML that sphinx-test-reports, S-CORE's documentation, StrictDoc and lobster-gtest read:
 * flat suites, and a case for each file of scenarios or component tests. StrictDoc takes it for
 * LLVM lit's, where the class name after its first dot, and the name, are the path of the file; it
 * knows a file once only, and needs it to exist.
 */
final class EvidenceJunit {

  private EvidenceJunit() {}

  static String render(Evidence evidence) {
    Map<String, List<FileCase>> suites = new LinkedHashMap<>();
    suites.put("component-tests", cases(evidence, true));
    suites.put("scenarios", cases(evidence, false));
    suites.values().removeIf(List::isEmpty);
    StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    List<FileCase> all = suites.values().stream().flatMap(List::stream).toList();
    xml.append("<testsuites name=\"")
        .append(Xml.attribute(evidence.name()))
        .append('"')
        .append(counts(all))
        .append(">\n");
    suites.forEach(
        (name, cases) -> {
          xml.append("  <testsuite name=\"").append(name).append('"').append(counts(cases));
          xml.append(">\n");
          cases.forEach(each -> each.write(name, xml));
          xml.append("  </testsuite>\n");
        });
    return xml.append("</testsuites>\n").toString();
  }

  private static List<FileCase> cases(Evidence evidence, boolean ofComponents) {
    Map<String, List<Test>> files = new LinkedHashMap<>();
    evidence.tests().stream()
        .filter(each -> each.component().isPresent() == ofComponents)
        .forEach(each -> files.computeIfAbsent(file(each), file -> new ArrayList<>()).add(each));
    return files.entrySet().stream()
        .map(each -> new FileCase(evidence, each.getKey(), each.getValue()))
        .toList();
  }

  /** Returns the file of a test; its name if that is unknown, so that it is not left out. */
  private static String file(Test test) {
    return test.place().file().isEmpty() ? test.fullName() : test.place().file();
  }

  private static String counts(List<FileCase> cases) {
    return String.format(
        Locale.ROOT,
        " tests=\"%d\" failures=\"%d\" errors=\"0\" skipped=\"%d\" time=\"%.3f\"",
        cases.size(),
        cases.stream().filter(each -> each.result() == Result.FAILED).count(),
        cases.stream().filter(each -> each.result() == Result.NOT_TESTED).count(),
        cases.stream().mapToDouble(FileCase::seconds).sum());
  }

  /** The tests of a file as one: failed if one failed, passed if all passed. */
  private record FileCase(Evidence evidence, String file, List<Test> tests) {

    Result result() {
      if (tests.stream().anyMatch(each -> each.result() == Result.FAILED)) {
        return Result.FAILED;
      }
      boolean passed = tests.stream().allMatch(each -> each.result() == Result.PASSED);
      return passed ? Result.PASSED : Result.NOT_TESTED;
    }

    double seconds() {
      return tests.stream().mapToDouble(Test::seconds).sum();
    }

    void write(String suite, StringBuilder xml) {
      int slash = file.lastIndexOf('/');
      String folder = slash < 0 ? "." : file.substring(0, slash);
      xml.append("    <testcase classname=\"")
          .append(Xml.attribute(suite + "." + folder))
          .append("\" name=\"")
          .append(Xml.attribute(file.substring(slash + 1)))
          .append(String.format(Locale.ROOT, "\" time=\"%.3f\"", seconds()))
          .append(JunitLinks.attributes(SourceLocation.of(file), result() != Result.NOT_TESTED))
          .append(">\n");
      xml.append(JunitLinks.properties(links()));
      switch (result()) {
        case FAILED ->
            xml.append("      <failure message=\"")
                .append(Xml.attribute(text()))
                .append("\" type=\"failed\"></failure>\n");
        case NOT_TESTED ->
            xml.append("      <skipped message=\"").append(Xml.attribute(text())).append("\"/>\n");
        case PASSED -> {
          // Nothing is to be said of it.
        }
      }
      xml.append("    </testcase>\n");
    }

    private Trial.Evidence links() {
      List<String> supported =
          tests.stream()
              .filter(each -> each.result() == result())
              .flatMap(each -> evidence.supportedBy(each).stream())
              .toList();
      return new Trial.Evidence(
          SourceLocation.of(file),
          List.of(),
          evidence.requirements().stream()
              .map(Evidence.Requirement::id)
              .filter(supported::contains)
              .toList());
    }

    /** Returns the text of the first test with the result of all, and its name among several. */
    private String text() {
      Test first =
          tests.stream().filter(each -> each.result() == result()).findFirst().orElseThrow();
      return tests.size() == 1 ? first.text() : first.name() + ": " + first.text();
    }
  }
}
