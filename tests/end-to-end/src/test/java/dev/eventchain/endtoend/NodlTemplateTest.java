package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that interfaces in NoDL are valid by its own schema, and that they are read again. */
class NodlTemplateTest {

  private static final Path SCHEMAS =
      Program.ROOT.resolve("bundles/robot/workspace/src/test/resources/nodl/schema");
  private static final Path EXAMPLE = Program.ROOT.resolve("examples/radar-aeb");

  @TempDir private Path folder;

  @Test
  void interfacesAreValidAndComeBack() throws IOException {
    Path model = folder.resolve("chain.xmi");
    String chain = Files.readString(EXAMPLE.resolve("model/chain.xmi"));
    Files.writeString(
        model,
        chain
            .replaceFirst("<qos name=\"sensor_data\"/>", "<qos name=\"system_default\"/>")
            .replaceFirst(
                "<qos name=\"default\"/>",
                "<qos name=\"default\" deadline=\"20.5\" liveliness=\"MANUAL_BY_TOPIC\""
                    + " leaseDuration=\"1000\" durability=\"TRANSIENT_LOCAL\"/>"));
    Path out = folder.resolve("out");
    new Program().run("generate", "--template", "nodl", model, "-o", out).expect(0);
    JsonSchema schema = schema();
    List<Path> documents;
    try (Stream<Path> files = Files.list(out)) {
      documents = files.filter(file -> file.toString().endsWith(".nodl.yaml")).sorted().toList();
    }
    assertEquals(3, documents.size());
    for (Path document : documents) {
      assertEquals(Set.of(), schema.validate(read(document)), document.toString());
    }
    String tracking = Files.readString(out.resolve("radar_tracking.nodl.yaml"));
    assertTrue(tracking.contains("reliability: SYSTEM_DEFAULT"), tracking);
    assertTrue(tracking.contains("deadline_ns: 20500000\n"), tracking);
    Path project = folder.resolve("again");
    new Program()
        .run(
            "init",
            project,
            "--messages",
            EXAMPLE.resolve("software-base/msg"),
            "--nodl",
            documents.get(0),
            "--nodl",
            documents.get(1),
            "--nodl",
            documents.get(2))
        .expect(0);
    String described = Files.readString(project.resolve("software-base/components.json"));
    assertTrue(described.contains("\"Radar_Tracking\""), described);
    assertTrue(described.contains("\"deadline\": 20.5"), described);
    assertTrue(!described.contains("header"), described);
    new Program().run("validate", project).expect(0);
  }

  @Test
  void wrongUsageIsSaid() {
    new Program()
        .run("init", folder, "--nodl", "a.nodl.yaml", "--from-workspace", "ws")
        .expect(2)
        .says("exclude each other");
    new Program().run("init", folder, "--messages", "m").expect(2).says("--messages is about");
    new Program().run("init", folder, "--nodl", "a.nodl.yaml").expect(2).says("[file.missing]");
  }

  /** Returns NoDL's schema with that of its parameters, which is a file of its own. */
  private static JsonSchema schema() {
    String text = SourceText.read(SCHEMAS.resolve("nodl.schema.yaml")).text();
    ObjectNode schema =
        (ObjectNode) parse(SourceText.of("schema", text.replace("parameter.schema.yaml#", "#")));
    ObjectNode definitions = (ObjectNode) schema.path("definitions");
    read(SCHEMAS.resolve("parameter.schema.yaml"))
        .path("definitions")
        .properties()
        .forEach(each -> definitions.set(each.getKey(), each.getValue()));
    schema.remove("$id");
    return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V7).getSchema(schema);
  }

  private static JsonNode read(Path file) {
    return parse(SourceText.read(file));
  }

  private static JsonNode parse(SourceText text) {
    DocumentRules rules = DocumentRules.all(Rule.error("test.yaml"));
    return Document.parse(text, DocumentFormat.YAML, rules, found -> assertEquals("", found))
        .root();
  }
}
