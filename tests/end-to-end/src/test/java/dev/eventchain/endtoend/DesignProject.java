package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/**
 * A project with the requirements, the scenarios and the vehicle of an example, and with software
 * of another design: a file with its components as in {@code components.json}, and their code. A
 * component may be {@code given} by the example, or {@code use} code that is recorded for it.
 */
final class DesignProject {

  private static final ObjectMapper JSON = new ObjectMapper();

  private final Path example;
  private final Path base;

  private DesignProject(Path example, Path project) {
    this.example = example;
    this.base = project.resolve("software-base");
  }

  /**
   * Creates the project of a design in a folder, with the bounds on the strength of the example's
   * requirements, and runs it.
   *
   * @param strength the option that says whether strength is measured
   */
  static Program.Ended run(Path example, Path design, Path folder, String strength)
      throws IOException {
    DesignProject made = new DesignProject(example, folder);
    Files.createDirectories(made.base.resolve("components"));
    for (String part : List.of("requirements.md", "bench.yaml", "scenarios")) {
      if (Files.exists(example.resolve(part))) {
        Projects.copy(example.resolve(part), folder.resolve(part));
      }
    }
    for (String part : List.of("msg", "signals.json")) {
      Projects.copy(example.resolve("software-base").resolve(part), made.base.resolve(part));
    }
    made.write(new Yaml(new SafeConstructor(new LoaderOptions())).load(Files.readString(design)));
    new Program().run("init", folder).expect(0);
    Files.writeString(
        folder.resolve("eventchain.yaml"),
        strengthOf(Files.readString(example.resolve("eventchain.yaml"))),
        StandardOpenOption.APPEND);
    return new Program().run("run", folder, strength);
  }

  /** Returns the section on strength of the settings of an example. */
  private static String strengthOf(String settings) {
    Matcher section = Pattern.compile("(?m)^strength:.*\\R(?: .*(?:\\R|$))*").matcher(settings);
    assertTrue(section.find(), "the example has no bounds");
    return "\n" + section.group();
  }

  private void write(Map<String, Object> design) throws IOException {
    ArrayNode components = JSON.createArrayNode();
    for (JsonNode each : JSON.valueToTree(design.get("components"))) {
      ObjectNode component = (ObjectNode) each;
      components.add(
          component.has("given")
              ? given(component)
              : own(component, design.get("does").toString()));
    }
    Files.writeString(base.resolve("components.json"), components.toPrettyString());
  }

  private ObjectNode given(ObjectNode component) throws IOException {
    String name = component.path("given").asText();
    Path software = example.resolve("software-base");
    Projects.copy(
        software.resolve("components/" + name + ".py"), base.resolve("components/" + name + ".py"));
    for (JsonNode known : JSON.readTree(software.resolve("components.json").toFile())) {
      if (known.path("name").asText().equals(name)) {
        return ((ObjectNode) known).set("requirements", component.get("requirements"));
      }
    }
    throw new AssertionError("the example has no " + name);
  }

  private ObjectNode own(ObjectNode component, String does) throws IOException {
    String name = component.path("name").asText();
    code(name, component.remove("code").asText());
    JsonNode used = component.remove("uses");
    for (JsonNode each : used == null ? List.<JsonNode>of() : used) {
      code(each.asText().toLowerCase(Locale.ROOT), recorded(each.asText()));
    }
    component.findParents("field").forEach(it -> ((ObjectNode) it).put("description", does));
    return component.put("description", does).put("worst_case_execution_time", 1.0);
  }

  private void code(String module, String text) throws IOException {
    Files.writeString(base.resolve("components/" + module + ".py"), text);
  }

  /** Returns the recorded code of a component. */
  private String recorded(String name) throws IOException {
    try (Stream<Path> files = Files.list(example.resolve("recordings/implement"))) {
      for (Path file : files.toList()) {
        StringBuilder text = new StringBuilder();
        JSON.readTree(file.toFile())
            .at("/samples/0/text")
            .forEach(line -> text.append(line.asText()).append('\n'));
        if (text.indexOf("class " + name + ":") >= 0) {
          return text.toString().replaceAll("(?s)^```python\n|\n```\\s*$", "");
        }
      }
    }
    throw new AssertionError("no recorded code of " + name);
  }
}
