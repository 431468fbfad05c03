package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.modeler.EventChainReader;
import dev.eventchain.modeler.JsonDocument;
import dev.eventchain.modeler.Requirements;
import dev.eventchain.modeler.SoftwareBase;
import dev.eventchain.python.ComponentProbe;
import dev.eventchain.python.PythonEnvironment;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** What a language model is told about faults names no files and options, which it does not see. */
class RepairTextTest {
  private static final Path RESOURCES = Path.of("src/test/resources");
  private static final Path BASE = RESOURCES.resolve("design/base");
  private static final Pattern FILES =
      Pattern.compile(
          "\\.(json|yaml|md|xmi|ecore|msg|py)\\b|(^| )--[a-z]|(?<!['`])\\b[Ff]iles?\\b(?!['`])");

  /** The bundles whose findings may be about an answer. */
  private static final List<String> CHECKING =
      List.of("agents", "analysis", "documents", "messages", "modeler", "ocl", "python");

  private static final Pattern LITERAL = Pattern.compile("\"((?:[^\"\\\\\n]++|\\\\.)*+)\"");

  @Test
  void whatIsSaidAboutDesignsSpeaksOfTheAnswer() throws IOException {
    Requirements requirements = Requirements.read(SourceText.read(BASE.resolve("requirements.md")));
    SoftwareBase base = SoftwareBase.read(BASE);
    MessageCatalog messages =
        MessageCatalog.of(List.of(ExampleWorkflow.AEB.project().resolve("software-base/msg")));
    eachFault("design", ".json", text -> DesignAgent.check(text, requirements, base, messages));
  }

  @Test
  void whatIsSaidAboutComponentsSpeaksOfTheAnswer() throws IOException {
    ComponentProbe probe = new ComponentProbe(PythonEnvironment.ensure(message -> {}));
    SourceText chain = SourceText.read(RESOURCES.resolve("implement/chain.json"));
    ImplementationCheck check =
        new ImplementationCheck(
            probe, ChainView.of(JsonDocument.parse(chain).root()).components().get(0));
    eachFault("implement", ".py", check::check);
  }

  @Test
  void whatIsSaidAboutConstraintsSpeaksOfTheAnswer() throws IOException {
    Requirements requirements =
        Requirements.read(
            SourceText.of("r.md", PromptTemplate.resource("model/example.requirements.md")));
    SourceText chain =
        SourceText.of("chain.json", PromptTemplate.resource("model/example.chain.json"));
    ConstraintCheck check =
        new ConstraintCheck(
            List.of("DR-1", "DR-2"),
            List.of(EventchainPackage.eINSTANCE),
            List.of(
                EventChainReader.read(chain, "example", requirements, OptionalDouble.empty())
                    .root()));
    eachFault("constrain", ".ocl", check::check);
  }

  @Test
  void clausesAboutFilesAndOptionsAreLeftOut() {
    Diagnostic finding =
        Diagnostic.error("any.id", "It is wrong.", SourceLocation.NONE)
            .withHint(
                "Did you mean `a`? Known is b; name another one with --metamodel FILE.ecore.");
    String text = FindingsText.of(List.of(finding));
    assertTrue(text.endsWith("   Did you mean `a`? Known is b.\n"), text);
  }

  /** Whatever the checks can say, in whichever finding: all texts that their bundles have. */
  @Test
  void noTextOfAnyFindingSpeaksOfFiles() throws IOException {
    Set<String> texts = new TreeSet<>();
    for (String bundle : CHECKING) {
      try (Stream<Path> files = Files.walk(Path.of("..", bundle, "src/main/java"))) {
        for (Path file : files.filter(path -> path.toString().endsWith(".java")).toList()) {
          Matcher found = LITERAL.matcher(Files.readString(file).replaceAll("\"\\s*\\+ *\"", ""));
          while (found.find()) {
            texts.add(found.group(1).replace("\\\"", "\""));
          }
        }
      }
    }
    assertTrue(texts.stream().filter(text -> FILES.matcher(text).find()).count() > 20);
    texts.removeIf(text -> !text.contains(" "));
    for (String text : texts) {
      Diagnostic finding = Diagnostic.error("any.id", "It is wrong.", SourceLocation.NONE);
      String hint = FindingsText.of(List.of(finding.withHint(text)));
      assertFalse(FILES.matcher(hint).find(), hint);
      String message =
          FindingsText.of(List.of(Diagnostic.error("any.id", text, SourceLocation.NONE)));
      assertFalse(message.contains(" file ") || message.contains(" file."), message);
    }
  }

  private static void eachFault(
      String folder, String suffix, Function<SourceText, List<Diagnostic>> check)
      throws IOException {
    try (Stream<Path> files = Files.list(RESOURCES.resolve(folder))) {
      for (Path file : files.filter(path -> path.toString().endsWith(suffix)).sorted().toList()) {
        String text = FindingsText.of(check.apply(SourceText.read(file)));
        String hints =
            String.join("\n", text.lines().filter(line -> !line.startsWith("   > ")).toList());
        assertFalse(FILES.matcher(hints).find(), () -> file + ":\n" + text);
      }
    }
  }
}
