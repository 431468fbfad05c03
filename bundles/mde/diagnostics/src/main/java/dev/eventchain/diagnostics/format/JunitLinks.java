package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.diagnostics.Xml;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The place of a test case and its requirements in JUnit XML, as sphinx-test-reports, S-CORE's
 * documentation, StrictDoc and lobster-gtest read them: each property once, since one of them takes
 * the last and another one none of several, and ids joined by commas.
 */
public final class JunitLinks {

  private JunitLinks() {}

  /**
   * Returns the attributes for the place of a test, which may be unknown, and whether it ran: a
   * reader that does not know {@code skipped} needs the latter.
   */
  public static String attributes(SourceLocation place, boolean ran) {
    String status = " status=\"" + (ran ? "run" : "notrun") + '"';
    return place.file().isEmpty()
        ? status
        : String.format(
                Locale.ROOT,
                " file=\"%s\" line=\"%d\"",
                Xml.attribute(place.file()),
                Math.max(1, place.line()))
            + status;
  }

  /** Returns the element with the properties; empty if there is no requirement. */
  public static String properties(Trial.Evidence evidence) {
    Map<String, String> properties = new LinkedHashMap<>();
    put(properties, "FullyVerifies", evidence.fully());
    put(properties, "PartiallyVerifies", evidence.partially());
    if (properties.isEmpty()) {
      return "";
    }
    put(
        properties,
        "lobster-tracing",
        Stream.concat(evidence.fully().stream(), evidence.partially().stream()).toList());
    properties.put("TestType", "requirements-based");
    properties.put("DerivationTechnique", "requirements-analysis");
    return element(properties);
  }

  /** Returns the element with properties; empty if there are none. */
  static String element(Map<String, String> properties) {
    return properties.isEmpty()
        ? ""
        : properties.entrySet().stream()
            .map(each -> property(each.getKey(), each.getValue()))
            .collect(Collectors.joining("", "      <properties>\n", "      </properties>\n"));
  }

  private static void put(Map<String, String> properties, String name, List<String> ids) {
    if (!ids.isEmpty()) {
      properties.put(name, String.join(", ", ids));
    }
  }

  private static String property(String name, String value) {
    return "        <property name=\"%s\" value=\"%s\"/>\n".formatted(name, Xml.attribute(value));
  }
}
