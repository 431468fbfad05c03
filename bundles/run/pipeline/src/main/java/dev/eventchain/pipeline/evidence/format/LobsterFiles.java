package dev.eventchain.pipeline.evidence.format;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Component;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Files of LOBSTER: requirements, components as implementations, tests and scenarios as activities,
 * and a configuration that traces both to the requirements. LOBSTER counts references, whatever the
 * status of an item; so what did not pass has no reference, and says why in its messages, which
 * also keep an item from counting as complete.
 */
final class LobsterFiles {

  private static final String REQUIREMENTS = "requirements.lobster";
  private static final String COMPONENTS = "components.lobster";
  private static final String TESTS = "tests.lobster";
  private static final String CONFIGURATION = "lobster.conf";

  /** The names of all files. */
  static final List<String> NAMES = List.of(REQUIREMENTS, COMPONENTS, TESTS, CONFIGURATION);

  private static final String TRACING =
      """
      requirements "Requirements" {
        source: "requirements.lobster";
      }
      implementation "Components" {
        source: "components.lobster";
        trace to: "Requirements";
      }
      activity "Tests" {
        source: "tests.lobster";
        trace to: "Requirements";
      }
      """;

  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private LobsterFiles() {}

  static Map<String, byte[]> render(Evidence evidence) {
    ArrayNode requirements = JSON.arrayNode();
    evidence.requirements().forEach(each -> requirements.add(requirement(each)));
    ArrayNode components = JSON.arrayNode();
    evidence.components().forEach(each -> components.add(component(each)));
    ArrayNode tests = JSON.arrayNode();
    evidence.tests().forEach(each -> tests.add(test(evidence, each)));
    Map<String, byte[]> files = new LinkedHashMap<>();
    files.put(REQUIREMENTS, file("lobster-req-trace", 4, requirements));
    files.put(COMPONENTS, file("lobster-imp-trace", 3, components));
    files.put(TESTS, file("lobster-act-trace", 3, tests));
    files.put(CONFIGURATION, TRACING.getBytes(StandardCharsets.UTF_8));
    return files;
  }

  private static byte[] file(String schema, int version, ArrayNode data) {
    ObjectNode file = JSON.objectNode();
    file.put("schema", schema).put("version", version).put("generator", "eventchain");
    file.set("data", data);
    return (JsonLayout.compact(file) + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private static ObjectNode requirement(Requirement requirement) {
    ObjectNode item = item("req", requirement.id(), requirement.place());
    item.put("framework", "eventchain").put("kind", "requirement");
    item.put("text", requirement.text()).put("status", requirement.verdict().words());
    if (requirement.verdict() != Verdict.PROVED) {
      item.withArray("messages").add(requirement.words());
    }
    return item;
  }

  private static ObjectNode component(Component component) {
    ObjectNode item = item("component", component.name(), component.place());
    item.put("language", "Python").put("kind", "component");
    component.satisfies().forEach(each -> item.withArray("refs").add("req " + each));
    return item;
  }

  private static ObjectNode test(Evidence evidence, Test test) {
    boolean isScenario = test.component().isEmpty();
    ObjectNode item = item(isScenario ? "scenario" : "test", test.fullName(), test.place());
    item.put("framework", "eventchain").put("kind", isScenario ? "scenario" : "component test");
    item.put("status", status(test.result()));
    if (test.result() == Result.PASSED) {
      evidence.supportedBy(test).forEach(each -> item.withArray("refs").add("req " + each));
    } else {
      String words = test.result().words();
      boolean says = test.text().startsWith(words);
      item.withArray("messages").add(says ? test.text() : words + ": " + test.text());
    }
    return item;
  }

  private static String status(Result result) {
    return switch (result) {
      case PASSED -> "ok";
      case FAILED -> "fail";
      case NOT_TESTED -> "not run";
    };
  }

  /** Returns an item without references; what follows an at sign would be its version. */
  private static ObjectNode item(String namespace, String name, SourceLocation place) {
    ObjectNode item = JSON.objectNode();
    item.put("tag", namespace + " " + name.replace('@', '_'));
    item.set("location", location(place));
    item.put("name", name);
    for (String empty : List.of("messages", "just_up", "just_down", "just_global", "refs")) {
      item.putArray(empty);
    }
    return item;
  }

  private static ObjectNode location(SourceLocation place) {
    ObjectNode location = JSON.objectNode();
    if (place.file().isEmpty()) {
      return location.put("kind", "void");
    }
    location.put("kind", "file").put("file", place.file()).put("line", Math.max(1, place.line()));
    return place.column() > 0 ? location.put("column", place.column()) : location.putNull("column");
  }
}
