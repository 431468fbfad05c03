package dev.eventchain.diagnostics.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.SchemaFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.xml.sax.SAXException;

/** Reports in each format, compared byte by byte and validated by the schema of the format. */
class ReportFilesTest {

  private static final Path EXPECTED =
      Path.of("src/test/resources/dev/eventchain/diagnostics/format/reports");

  @ParameterizedTest
  @EnumSource
  void aReportWithOneOfEverythingGivesTheseBytes(DiagnosticFormat format) throws IOException {
    String actual = format.render(Reports.full());
    Path file = EXPECTED.resolve("full." + format.name().toLowerCase(Locale.ROOT));
    if (!Files.exists(file)) {
      Files.createDirectories(EXPECTED);
      Files.writeString(file, actual);
      fail("wrote the missing expectation " + file);
    }
    assertEquals(Files.readString(file), actual);
  }

  @Test
  void sarifIsValidByItsSchema() throws IOException {
    JsonSchema schema = sarifSchema();
    for (Report report : all()) {
      JsonNode sarif = json(DiagnosticFormat.SARIF.render(report));
      assertEquals(List.of(), List.copyOf(schema.validate(sarif)));
    }
    JsonNode broken = json("{\"version\": \"2.1.0\", \"runs\": [{}]}");
    assertNotEquals(0, schema.validate(broken).size(), "the schema finds what is wrong");
  }

  /** The schema of Jenkins' xUnit plug-in, which knows no properties of a test case. */
  @Test
  void junitIsValidByItsSchemaApartFromLinks() throws Exception {
    var schema =
        SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI)
            .newSchema(ReportFilesTest.class.getResource("junit-10.xsd"));
    for (Report report : all()) {
      String xml =
          DiagnosticFormat.JUNIT
              .render(report)
              .replaceAll("( file=\"[^\"]*\" line=\"1\")? status=\"(not)?run\"", "")
              .replaceAll("(?s) *<properties>.*?</properties>\n", "");
      try {
        schema.newValidator().validate(new StreamSource(new StringReader(xml)));
      } catch (SAXException e) {
        fail(e.getMessage() + "\n" + xml);
      }
    }
  }

  /** Viewers show nothing for a relative name that leaves its base. */
  @ParameterizedTest
  @CsvSource({
    "FOLDER/a b/x.xmi, a%20b/x.xmi, SRCROOT",
    "FOLDER/../x.xmi, file://ABOVE/x.xmi,",
    "../x.xmi, file://ABOVE/x.xmi,",
    "../diagnostics/x.xmi, x.xmi, SRCROOT",
    "../diagnostics2/x.xmi, file://ABOVE/diagnostics2/x.xmi,",
    "..x/y.xmi, ..x/y.xmi, SRCROOT",
    "x.xmi, x.xmi, SRCROOT",
    "FOLDER, ., SRCROOT",
    "/, file:///,",
  })
  void sarifNamesFilesInTheWorkingFolderRelativelyAndOthersAbsolutely(
      String file, String uri, String base) throws IOException {
    Path folder = Path.of("").toAbsolutePath();
    String name = file.replace("FOLDER", folder.toString());
    Diagnostic finding = Diagnostic.of(Rule.error("a.b"), "It is wrong.", SourceLocation.of(name));
    Report report =
        new Report("", 1, new Coverage(List.of(name), 1, List.of()), List.of(finding), List.of());
    JsonNode run = json(DiagnosticFormat.SARIF.render(report)).at("/runs/0");
    for (String pointer :
        List.of(
            "/artifacts/0/location", "/results/0/locations/0/physicalLocation/artifactLocation")) {
      JsonNode artifact = run.at(pointer);
      String expected = uri.replace("ABOVE", folder.getParent().toString());
      assertEquals(expected, artifact.get("uri").asText());
      assertEquals(base, artifact.path("uriBaseId").textValue());
    }
  }

  @Test
  void aFileHasTheSameFingerprintByEachOfItsNames() throws IOException {
    String absolute = Path.of("x.xmi").toAbsolutePath().toString();
    assertEquals(fingerprintIn("x.xmi"), fingerprintIn(absolute));
    assertNotEquals(fingerprintIn("x.xmi"), fingerprintIn("../x.xmi"));
  }

  private static JsonNode fingerprintIn(String file) throws IOException {
    Diagnostic finding = Diagnostic.of(Rule.error("a.b"), "It is wrong.", SourceLocation.of(file));
    return json(DiagnosticFormat.SARIF.render(List.of(finding)))
        .at("/runs/0/results/0/partialFingerprints");
  }

  private static List<Report> all() {
    Diagnostic strange =
        Diagnostic.of(
                Rule.error("a.b"),
                "\u0000 \uD800 \uFFFF ]]> <&\"'\n\t",
                new SourceLocation("a\\b:c%", 1, 0, "\u0001", "\uDC00".repeat(300)))
            .withRule("a/b\u0002");
    return List.of(
        Reports.full(),
        Report.of(List.of()),
        Report.of(List.of(strange)),
        new Report("", 2, Coverage.NONE, List.of(strange), List.of()));
  }

  @Test
  void fingerprintsStayWhenLinesMove() throws IOException {
    Diagnostic finding = Reports.full().diagnostics().get(0);
    SourceLocation old = finding.location();
    Diagnostic moved =
        finding.withLocation(
            new SourceLocation(old.file(), 99, 1, old.element(), "  " + old.excerpt()));
    assertEquals(fingerprints(finding), fingerprints(moved));
    assertNotEquals(
        fingerprints(finding), fingerprints(finding.withLocation(old.withElement("other"))));
    List<String> twice = fingerprints(finding, finding);
    assertNotEquals(twice.get(0), twice.get(1));
  }

  private static List<String> fingerprints(Diagnostic... findings) throws IOException {
    return json(DiagnosticFormat.SARIF.render(List.of(findings)))
        .findValuesAsText("eventchainFinding/v1");
  }

  @Test
  void aCommandThatCouldNotWorkSaysSo() throws IOException {
    Report failed = new Report("", 2, Coverage.NONE, Report.of(List.of()).diagnostics(), List.of());
    JsonNode run = json(DiagnosticFormat.SARIF.render(failed)).at("/runs/0/invocations/0");
    assertEquals(2, run.get("exitCode").asInt());
    assertTrue(run.get("executionSuccessful").isBoolean());
    assertEquals(false, run.get("executionSuccessful").asBoolean());
  }

  private static JsonSchema sarifSchema() throws IOException {
    try (InputStream schema =
        ReportFilesTest.class.getResourceAsStream("/schema/sarif-schema-2.1.0.json")) {
      return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V7).getSchema(schema);
    }
  }

  private static JsonNode json(String text) throws IOException {
    return new ObjectMapper().readTree(text);
  }
}
