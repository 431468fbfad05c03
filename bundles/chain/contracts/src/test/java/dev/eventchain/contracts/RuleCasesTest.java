package dev.eventchain.contracts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.project.SoftwareBase;
import dev.eventchain.xmi.LoadedModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Test cases: a folder for each rule with cases that violate it, and one, {@code good}, that
 * satisfies it. A case is a software base with a {@code chain.xmi}, and {@code expected.txt}.
 */
class RuleCasesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");

  static Stream<String> cases() throws IOException {
    return ExpectedFile.cases(CASES);
  }

  @ParameterizedTest
  @MethodSource("cases")
  void findsWhatIsExpected(String name) throws IOException {
    Path folder = CASES.resolve(name);
    AnalysisResult result = analyse(folder);
    String rule = name.substring(0, name.indexOf('/'));
    String actual = DiagnosticFormat.TEXT.render(result.diagnostics()).replace(folder + "/", "");
    ExpectedFile.check(folder.resolve("expected.txt"), actual);
    result
        .diagnostics()
        .forEach(d -> assertTrue(d.severity().compareTo(worst(result, d.id())) >= 0, d.message()));
    boolean found = result.diagnostics().stream().map(Diagnostic::id).anyMatch(rule::equals);
    assertEquals(!name.endsWith("/good"), found, rule);
    assertNotEquals(0, count(result, rule), "not checked");
  }

  /** Findings do not depend on hash order. */
  @ParameterizedTest
  @MethodSource("cases")
  void findsTheSameTwice(String name) {
    Path folder = CASES.resolve(name);
    assertEquals(analyse(folder), analyse(folder));
  }

  @Test
  void everyRuleHasAPageAndAGoodAndABadCase() throws IOException {
    Set<String> rules =
        Arrays.stream(ContractRule.values())
            .map(ContractRule::id)
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(rules, names(Path.of("rules")));
    assertEquals(rules, names(CASES));
    for (String rule : rules) {
      assertTrue(names(CASES.resolve(rule)).containsAll(Set.of("good", "bad")), rule);
    }
  }

  @Test
  void withoutSignalsNobodyKnowsTheEndsOfTheChain() {
    Path folder = CASES.resolve("contract.publisher.missing/bad");
    AnalysisResult result = analyse(folder, SoftwareBase.read(folder.resolve("none")));
    assertEquals(0, count(result, "contract.publisher.missing"));
    assertEquals(0, count(result, "contract.consumer.missing"));
    assertEquals(List.of(), result.diagnostics());
    assertNotEquals(0, count(result, "contract.qos.incompatible"));
  }

  @Test
  void everyRuleIsCountedInItsOrder() {
    AnalysisResult result = analyse(CASES.resolve("contract.field.unknown/good"));
    assertEquals(
        Arrays.stream(ContractRule.values()).map(ContractRule::id).toList(),
        result.checks().stream().map(Coverage.Check::id).toList());
  }

  private static Severity worst(AnalysisResult result, String rule) {
    return result.checks().stream()
        .filter(check -> check.id().equals(rule))
        .findFirst()
        .orElseThrow()
        .severity();
  }

  private static long count(AnalysisResult result, String rule) {
    return result.checks().stream()
        .filter(check -> check.id().equals(rule))
        .mapToLong(Coverage.Check::evaluations)
        .sum();
  }

  static AnalysisResult analyse(Path folder) {
    SoftwareBase base = SoftwareBase.read(folder);
    // Each case contains only elements that its rule concerns.
    List<Diagnostic> wrong =
        base.diagnostics().stream().filter(found -> !found.id().equals("file.missing")).toList();
    assertEquals(List.of(), wrong);
    return analyse(folder, base);
  }

  private static AnalysisResult analyse(Path folder, SoftwareBase base) {
    Path messages = folder.resolve("msg");
    MessageCatalog catalog =
        MessageCatalog.of(Files.isDirectory(messages) ? List.of(messages) : List.of());
    LoadedModel model = EventChainMetamodel.store(folder).load(folder.resolve("chain.xmi"));
    return ChainAnalysis.of(catalog, base.signals())
        .check((EventChain) model.roots().get(0), model.origins()::locate);
  }

  private static Set<String> names(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString().replaceFirst("\\.md$", ""))
          .collect(Collectors.toCollection(TreeSet::new));
    }
  }
}
