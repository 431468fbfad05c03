package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.NullNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SuppressionFileTest {

  private static final LocalDate TODAY = LocalDate.of(2026, 11, 21);

  @TempDir Path folder;

  /** A page is a file in a jar, and an editor reads the suppressions after each pause in typing. */
  @Test
  void thePageAboutAnIdIsLookedUpOnce() throws IOException {
    Path file = folder.resolve("suppressions.yaml");
    String entry = "- {id: %s, reason: Later., expires: 2027-03-31}\n";
    Files.writeString(file, (entry.formatted("ocl.violated") + entry.formatted("a.b")).repeat(50));
    List<String> asked = new ArrayList<>();
    Suppressions read =
        SuppressionFile.read(
            file,
            TODAY,
            id -> {
              asked.add(id);
              return Optional.empty();
            });
    assertEquals(100, read.inForce().size());
    assertEquals(List.of("ocl.violated", "a.b"), asked);
  }

  @Test
  void anEntrySuppressesWhatItDescribes() throws IOException {
    Suppressions suppressions =
        read(
            """
            # What we live with.
            - id: ocl.violated
              rule: Book::HasPages
              element: Library/books[*]
              reason: Counted next year.
              expires: 2027-03-31
            """);
    Diagnostic meant =
        Diagnostic.of(
                Rule.error("ocl.violated"),
                "m",
                SourceLocation.NONE.withElement("Library/books[1]"))
            .withRule("Book::HasPages");
    Suppressions.Parted parted =
        suppressions.part(List.of(meant, meant.withRule("Book::HasTitle")));
    assertEquals(1, parted.remaining().size());
    Suppressions.Entry by = parted.suppressed().get(0).by();
    assertEquals("Counted next year.", by.reason());
    assertEquals(LocalDate.of(2027, 3, 31), by.expires());
    assertEquals(2, by.location().line());
  }

  @Test
  void aFileOfCommentsSuppressesNothing() throws IOException {
    assertEquals(List.of(), read("# nothing yet\n").warnings(List.of(), Coverage.NONE, true));
  }

  @ParameterizedTest(name = "{index}: {1} {2}")
  @CsvSource(
      delimiter = '|',
      value = {
        "- id: a.b;  expires: 2027-03-31|1:3|'reason' is missing",
        "- id: a.b;  reason: ' ';  expires: 2027-03-31|2:11|'reason' is empty",
        "- id: a.b;  reason: r|1:3|'expires' is missing",
        "- reason: r;  expires: 2027-03-31|1:3|'id' is missing",
        "- id: a.b;  reason: r;  expires: 2027-02-30|3:12|not a date",
        "- id: a.b;  reason: r;  expires: soon|3:12|not a date",
        "- id: a.b;  reason: r;  expires: ~|3:12|'expires' must be a string, but there is nothing",
        "- id: a.b;  reason: r;  expires: 2027|3:12|'expires' must be a string, not a number 2027",
        "- id: a.b;  rul: x;  reason: r;  expires: 2027-03-31|2:3|no key 'rul'",
        "- id: a.b;  id: a.c;  reason: r;  expires: 2027-03-31|2:3|is duplicated",
        "- id: ocl.nothing-evaluated;  reason: r;  expires: 2027-03-31|1:7|cannot be suppressed",
        "- id: xmi.syntax;  reason: r;  expires: 2027-03-31|1:7|cannot be suppressed",
        "- a|1:3|must be a mapping",
        "id: a.b|1:1|must hold a list",
        "- [|2:1|not valid YAML",
        "- id: a.b;  reason: r;  expires: 2027-03-31;---;- id: c.d|4:1|second document",
      })
  void whatIsNotUnderstoodIsNamedWithItsPlace(String text, String place, String problem) {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> read(text.replace(';', '\n') + "\n"));
    assertEquals(DiagnosticException.Reason.INPUT, refused.reason());
    String all =
        refused.diagnostics().stream()
            .map(found -> found.id() + " " + found.location() + " " + found.message())
            .collect(Collectors.joining("\n"));
    assertEquals(1, refused.diagnostics().size(), all);
    assertEquals(true, all.startsWith("suppression.invalid "), all);
    assertEquals(true, all.contains(":" + place + " "), all);
    assertEquals(true, all.contains(problem), all);
  }

  /** What the reader takes, the schema accepts; what the reader refuses, it refuses. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "# nothing yet|true",
        "[]|true",
        "- id: a.b;  reason: r;  expires: 2027-03-31|true",
        "- id: a.b;  reason: r;  expires: ' 2027-03-31 '|true",
        "- {id: a.b, reason: r, expires: 2027-03-31, rule: '', element: e, file: f, message: m}|true",
        "- id: a.b;  expires: 2027-03-31|false",
        "- id: ' ';  reason: r;  expires: 2027-03-31|false",
        "- id: a.b;  reason: ' ';  expires: 2027-03-31|false",
        "- id: a.b;  reason: r|false",
        "- reason: r;  expires: 2027-03-31|false",
        "- id: a.b;  reason: r;  expires: soon|false",
        "- id: a.b;  reason: r;  expires: 2027-13-01|false",
        "- id: a.b;  reason: r;  expires: ~|false",
        "- id: a.b;  reason: r;  expires: 2027|false",
        "- id: a.b;  rul: x;  reason: r;  expires: 2027-03-31|false",
        "- id: a.b;  rule: 5;  reason: r;  expires: 2027-03-31|false",
        "- a|false",
        "id: a.b|false",
      })
  void theSchemaAgreesWithTheReader(String written, boolean isRead) {
    String text = written.replace(';', '\n') + "\n";
    SourceText source = SourceText.of("s.yaml", text);
    JsonNode value =
        Document.parseIfAny(source, DocumentFormat.YAML, ProjectSettings.RULES, problem -> {})
            .map(Document::root)
            .orElse(NullNode.instance);
    JsonSchema schema =
        JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
            .getSchema(SuppressionFile.schema());
    assertEquals(isRead, schema.validate(value).isEmpty(), text);
    assertEquals(
        isRead,
        assertDoesNotThrow(
            () -> {
              try {
                read(text);
                return true;
              } catch (DiagnosticException e) {
                return false;
              }
            }),
        text);
  }

  private Suppressions read(String text) throws IOException {
    return SuppressionFile.read(Files.writeString(folder.resolve("s.yaml"), text), TODAY);
  }
}
