package dev.eventchain.project;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.description.EventChainReader;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.jsonmodels.Modeled;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.EventChain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Test cases, one per folder; {@code expected.txt} holds the findings and, without errors, the
 * result.
 */
class ProjectCasesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");

  static Stream<String> cases() throws IOException {
    return ExpectedFile.cases(CASES);
  }

  @ParameterizedTest
  @MethodSource("cases")
  void saysWhatIsExpected(String name) throws IOException {
    Path folder = CASES.resolve(name);
    String actual = outcome(name.substring(0, name.indexOf('/')), folder);
    ExpectedFile.check(folder.resolve("expected.txt"), actual);
  }

  private static String outcome(String kind, Path folder) {
    try {
      return switch (kind) {
        case "base" -> base(folder);
        case "catalogue" -> catalogue(new ProjectFolder(folder));
        case "questions" -> render(OpenQuestions.read(new ProjectFolder(folder)), folder);
        case "requirements" -> requirements(folder);
        case "sources" -> sources(folder);
        default -> throw new IllegalArgumentException(kind);
      };
    } catch (DiagnosticException e) {
      assertEquals(DiagnosticException.Reason.INPUT, e.reason());
      return render(e.diagnostics(), folder);
    }
  }

  private static Modeled<EventChain> readChain(Path folder) {
    return EventChainReader.read(
        read(folder, "chain.json"),
        "aeb",
        Requirements.read(read(CASES, "requirements.md")).items(),
        OptionalDouble.empty());
  }

  private static String base(Path folder) {
    SoftwareBase base = SoftwareBase.read(folder);
    String text = render(base.diagnostics(), folder);
    for (SoftwareBase.Component component : base.components()) {
      text += component.name() + " " + component.implementation() + "\n";
    }
    if (Files.exists(folder.resolve("chain.json"))) {
      Modeled<EventChain> chain = readChain(folder);
      text += render(chain.diagnostics(), folder);
      text += "missing: " + base.missing(chain.root()).size() + "\n";
      text += render(base.check(chain.root(), chain.origins()::locate), folder);
    }
    return text;
  }

  private static String catalogue(ProjectFolder project) {
    CatalogueSettings settings = project.catalogue().orElseThrow();
    SoftwareBase base = project.readSoftwareBase();
    String chosen =
        String.format(
            Locale.ROOT,
            "shortlist %d, pinned %s, excluded %s%n",
            settings.shortlist(),
            settings.pinned(),
            settings.excluded());
    return chosen
        + base.signals().orElseThrow().stream()
            .map(it -> it.topic() + " " + it.direction() + " " + it.fields().get(0).unit() + "\n")
            .collect(Collectors.joining())
        + base.signalsText().strip()
        + "\n"
        + base.offering(base.catalogue().orElseThrow().signals().subList(0, 1)).signalsText()
        + "\n";
  }

  private static String requirements(Path folder) {
    Requirements read = Requirements.read(read(folder, "requirements.md"));
    return render(read.diagnostics(), folder)
        + read.items().stream()
            .map(item -> item.location().line() + " " + item.id() + " = " + item.text() + "\n")
            .collect(Collectors.joining());
  }

  private static String sources(Path folder) {
    Requirements read = new ProjectFolder(folder).readRequirements();
    return render(read.diagnostics(), folder)
        + read.items().stream()
            .map(item -> described(item).replace(folder + "/", ""))
            .collect(Collectors.joining());
  }

  private static String described(WrittenRequirement item) {
    WrittenRequirement.Details details = item.details();
    String parents =
        details.parents().stream()
            .map(parent -> " <- " + parent.id() + " " + parent.location())
            .collect(Collectors.joining());
    return "%s %s = %s (%s, %s, %s)%s%n"
        .formatted(
            item.location(),
            item.id(),
            item.text(),
            details.type().orElse("-"),
            details.status().orElse("-"),
            details.tags(),
            parents);
  }

  private static SourceText read(Path folder, String file) {
    return SourceText.read(folder.resolve(file));
  }

  private static String render(List<Diagnostic> diagnostics, Path folder) {
    return DiagnosticFormat.TEXT.render(diagnostics).replace(folder + "/", "");
  }
}
