package dev.eventchain.pipeline.project;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.ContainerNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NullNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.llm.service.ModelServices;
import dev.eventchain.messages.RosDistribution;
import dev.eventchain.project.ProjectSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the schema of {@code eventchain.yaml} agrees with its reader. */
class SettingsSchemaTest {

  private static final Path FOLDER = Path.of("project");
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final JsonSchema SCHEMA =
      JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
          .getSchema(Configuration.schema());

  /** Each setting, once. */
  private static final String ALL =
      """
      name: all
      title: Everything
      frequency: 10.5
      ros_distro: jazzy
      llm: auto
      models: {design: [openai/a, ours/b], test: c, implement: d, model: direct, constrain: e,
        diagnose: f}
      services:
        ours: {wire: openai-compatible, url: 'http://gpu.example:8000/v1', key: OURS_KEY,
          deadline_s: 600, silence_s: 60.5, maximum_tokens: 32000, temperature: 0.5, seed: 7}
        openai: {deadline_s: 10}
      command: {deadline_s: 600}
      prices: {openai/a: {input_per_million: 1.25, output_per_million: 10}}
      budget: {cost: 2, tokens: 500000}
      repairs: 2
      requirements:
        - file: a.reqif
          only: {type: [req], status: approved, tag: [safety, brake]}
          fields: {id: i, text: t, status: s, tags: g, parents: [up]}
      catalogue: {file: a.vspec, overlays: [b.vspec], node: N,
        shortlist: 20, pinned: [A.B], excluded: [C]}
      template: ros2-python
      strength: {extent: whole, budget_s: 90, minimum_percent: 60, requirements: {R-1: 40}}
      package: {license: EPL-2.0, maintainer: Somebody, email: a@b.example}
      """;

  private static JsonNode yaml(String text) {
    SourceText source = SourceText.of("eventchain.yaml", text);
    return Document.parse(source, DocumentFormat.YAML, ProjectSettings.RULES, problem -> {}).root();
  }

  /** Returns what the reader says; empty if it takes the text. */
  private static String refusal(String text) {
    try {
      Configuration.read(SourceText.of("eventchain.yaml", text), FOLDER);
      return "";
    } catch (DiagnosticException e) {
      return e.diagnostics().toString();
    }
  }

  private static void agree(String text) {
    String refusal = refusal(text);
    String invalid = SCHEMA.validate(yaml(text)).toString();
    assertEquals(
        refusal.isEmpty(), invalid.equals("[]"), text + "\nreader: " + refusal + "\n" + invalid);
  }

  @Test
  void allSettingsAreRead() {
    assertEquals("", refusal(ALL));
    assertEquals("[]", SCHEMA.validate(yaml(ALL)).toString());
  }

  static List<Path> everyProjectOfTheExamplesIsValid() throws IOException {
    try (Stream<Path> files = Files.list(Repository.ROOT.resolve("examples"))) {
      List<Path> found =
          files
              .map(each -> each.resolve("eventchain.yaml"))
              .filter(Files::exists)
              .sorted()
              .toList();
      assertTrue(found.size() > 3);
      return found;
    }
  }

  @ParameterizedTest
  @MethodSource
  void everyProjectOfTheExamplesIsValid(Path file) {
    assertEquals("[]", SCHEMA.validate(yaml(SourceText.read(file).text())).toString());
  }

  /** Each value of the file, and each key, is changed by itself. */
  @Test
  void theReaderAndTheSchemaAgreeOnEachChangeOfAValue() throws IOException {
    List<String> changed = new ArrayList<>();
    ContainerNode<?> whole = (ContainerNode<?>) yaml(ALL);
    change(whole, whole, changed, "");
    for (String text : changed) {
      agree(text);
    }
    assertTrue(changed.size() > 400, changed.size() + " changes");
  }

  private static List<JsonNode> others() {
    JsonNodeFactory make = JsonNodeFactory.instance;
    ArrayNode numbers = make.arrayNode().add(1);
    ArrayNode texts = make.arrayNode().add("some text");
    ObjectNode unknown = make.objectNode().put("zzz", 1);
    return List.of(
        IntNode.valueOf(-5),
        IntNode.valueOf(2_000_000_000),
        TextNode.valueOf(""),
        TextNode.valueOf("some text"),
        BooleanNode.TRUE,
        NullNode.instance,
        make.arrayNode(),
        numbers,
        texts,
        make.objectNode(),
        unknown);
  }

  /** Adds the texts of a whole document with a change in one of its parts, which are put back. */
  private static void change(
      ContainerNode<?> part, ContainerNode<?> root, List<String> texts, String path)
      throws IOException {
    if (part instanceof ObjectNode object) {
      object.put("zzz", "x");
      texts.add(JSON.writeValueAsString(root));
      object.remove("zzz");
      for (String key : new TreeSet<>(names(object))) {
        JsonNode value = object.remove(key);
        texts.add(JSON.writeValueAsString(root));
        for (JsonNode other : others()) {
          // Which templates there are is no matter of the schema.
          if (!(path + key).equals("template") || !other.isTextual()) {
            object.set(key, other);
            texts.add(JSON.writeValueAsString(root));
          }
        }
        object.set(key, value);
        changeBelow(value, root, texts, path + key + ".");
      }
    } else if (part instanceof ArrayNode array) {
      for (int i = 0; i < array.size(); i++) {
        JsonNode value = array.get(i);
        for (JsonNode other : others()) {
          array.set(i, other);
          texts.add(JSON.writeValueAsString(root));
        }
        array.set(i, value);
        changeBelow(value, root, texts, path + i + ".");
      }
    }
  }

  private static void changeBelow(
      JsonNode value, ContainerNode<?> root, List<String> texts, String path) throws IOException {
    if (value instanceof ContainerNode<?> below) {
      change(below, root, texts, path);
    }
  }

  private static List<String> names(ObjectNode object) {
    List<String> names = new ArrayList<>();
    object.fieldNames().forEachRemaining(names::add);
    return names;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "name: Aeb",
        "name: aeb\nstrength: on",
        "name: aeb\nstrength: true",
        "name: aeb\nstrength: off",
        "name: aeb\nstrength: half",
        "name: aeb\nstrength: {extent: off}",
        "name: aeb\nrequirements: a.sdoc",
        "name: aeb\nrequirements: ' '",
        "name: aeb\nrequirements: [a.sdoc, b.sdoc]",
        "name: aeb\nrequirements: [a.sdoc, {file: b.sdoc}]",
        "name: aeb\nrequirements: [{file: b.sdoc}, a.sdoc]",
        "name: aeb\nrequirements: {file: a.sdoc}",
        "name: aeb\ncatalogue: a.vspec",
        "name: aeb\nfrequency: 0",
        "name: aeb\nfrequency: 10001",
        "name: aeb\nros_distro: foxy",
        "name: aeb\nservices: {ours: {wire: ollama}}",
        "name: aeb\nservices: {ours: {url: 'http://a'}}",
        "name: aeb\nservices: {ours: {wire: ollama, url: 'http://a:1/b'}}",
        "name: aeb\nservices: {ours: {wire: ollama, url: 'http://user:key@a'}}",
        "name: aeb\nservices: {ours: {wire: ollama, url: 'ftp://a'}}",
        "name: aeb\nservices: {groq: {url: 'https://a'}}",
        "name: aeb\nmodels: {design: []}",
      })
  void theReaderAndTheSchemaAgree(String text) {
    agree(text + "\n");
  }

  @Test
  void theSchemaKnowsTheWordsOfTheReader() throws IOException {
    JsonNode schema = JSON.readTree(Configuration.schema());
    assertEquals(
        RosDistribution.ids(), texts(schema.at("/properties/ros_distro/enum")), "releases");
    JsonNode services = schema.at("/properties/services/properties");
    assertEquals(
        List.copyOf(ModelServices.usual().names()), names((ObjectNode) services), "services");
    for (String wire : texts(schema.at("/$defs/service/properties/wire/enum"))) {
      agree("name: aeb\nservices: {ours: {wire: " + wire + ", url: 'http://a'}}\n");
    }
    String refusal = refusal("name: aeb\nservices: {ours: {wire: none, url: 'http://a'}}\n");
    String wires = String.join(", ", texts(schema.at("/$defs/service/properties/wire/enum")));
    assertTrue(refusal.contains("Use one of " + wires + "."), refusal);
  }

  private static List<String> texts(JsonNode array) {
    List<String> texts = new ArrayList<>();
    array.forEach(each -> texts.add(each.textValue()));
    return texts;
  }
}
