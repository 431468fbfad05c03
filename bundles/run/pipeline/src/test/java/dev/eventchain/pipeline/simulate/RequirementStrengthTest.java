package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.project.StrengthExtent;
import dev.eventchain.pipeline.project.StrengthSettings;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.RequirementOutcome.Bound;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.verdict.Strength.LeftOut;
import dev.eventchain.simulation.verdict.Strength.Reaction;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the findings about the strength of evidence. */
class RequirementStrengthTest {

  private static final StrengthSettings HALF =
      new StrengthSettings(StrengthExtent.SAMPLE, 600, 50, new TreeMap<>());

  @Test
  void enoughNoticedFaultsAreNoFinding() {
    RequirementStrength strength = strength(true, true, true, false);
    assertEquals(List.of(), strength.findings());
    assertTrue(!strength.isUntested("BRK-1"));
  }

  @Test
  void aComponentThatMayBeIdleIsNotTested() {
    RequirementStrength strength = strength(false, true, true, false);
    Diagnostic found = only(strength);
    assertEquals("simulation.strength.idle", found.id());
    assertEquals(3, found.location().line());
    assertEquals("BRK-1", found.rule());
    assertTrue(
        found.message().contains("'Brake' sends nothing on /emergency, or"), found.message());
    assertTrue(strength.isUntested("BRK-1"));
  }

  @Test
  void criteriaThatNoticeNothingTestNothing() {
    RequirementStrength strength = strength(true, false, false);
    assertEquals("simulation.strength.none", only(strength).id());
    assertTrue(strength.isUntested("BRK-1"));
  }

  @Test
  void scenariosInWhichNoFaultChangesAnythingTestNothing() {
    assertEquals("simulation.strength.none", only(strength(true)).id());
  }

  @Test
  void tooFewNoticedFaultsAreNamed() {
    RequirementStrength strength = strength(true, true, false, false);
    Diagnostic found = only(strength);
    assertEquals("simulation.strength.low", found.id());
    assertTrue(found.message().contains("notice 1 of 3 standard faults: 33.3 %"), found.message());
    assertTrue(!strength.isUntested("BRK-1"));
  }

  @Test
  void aDesignMayLetFurtherComponentsContribute() {
    List<List<String>> upstream = List.of(List.of("Brake", "Radar"));
    List<Reaction> more = reactions("Brake", 4, 8);
    more.addAll(reactions("Radar", 0, 33));
    assertTrue(strength(upstream, Set.of(), more).findings().isEmpty());
    List<Reaction> less = reactions("Brake", 3, 8);
    less.addAll(reactions("Radar", 0, 33));
    Diagnostic found = only(strength(upstream, Set.of(), less));
    assertEquals("simulation.strength.low", found.id());
    assertTrue(
        found.message().contains("3 of 8 standard faults of 'Brake' that count for the bound:"),
        found.message());
    List<Reaction> sharp = reactions("Brake", 3, 8);
    sharp.addAll(reactions("Radar", 5, 9));
    assertTrue(strength(upstream, Set.of(), sharp).findings().isEmpty());
  }

  @Test
  void aContributionWithFewFaultsDoesNotCount() {
    List<Reaction> reactions = reactions("Filter", 1, 1);
    reactions.addAll(reactions("Brake", 2, 12));
    Diagnostic found = only(strength(List.of(List.of("Brake", "Filter")), Set.of(), reactions));
    assertTrue(found.message().contains("2 of 12 standard faults of 'Brake'"), found.message());
  }

  @Test
  void effectsThatNothingJudgesCount() {
    List<List<String>> both = List.of(List.of("Warner"), List.of("Brake"));
    List<Reaction> reactions = reactions("Warner", 9, 9);
    reactions.addAll(reactions("Brake", 0, 12));
    Diagnostic marked = only(strength(both, Set.of("/warning", "/brake"), reactions));
    assertTrue(marked.message().contains("0 of 12 standard faults of 'Brake'"), marked.message());
    Diagnostic found = only(strength(both, Set.of(), reactions));
    assertTrue(
        found
            .message()
            .contains("9 of 21 standard faults of 'Warner' and 'Brake' that count for the bound:"),
        found.message());
    reactions.addAll(reactions("Brake", 5, 5));
    assertTrue(strength(both, Set.of("/warning", "/brake"), reactions).findings().isEmpty());
  }

  /** A design may do in one component what another one does in two. */
  @Test
  void faultsOfAnOutputOfAnotherRequirementDoNotCount() {
    List<List<String>> alone = List.of(List.of("Brake"));
    List<Reaction> reactions = reactions("Brake", 4, 8);
    reactions("Brake", 0, 9).forEach(each -> reactions.add(each.withElsewhere(true)));
    RequirementStrength enough = strength(alone, Set.of(), reactions);
    assertEquals(List.of(), enough.findings());
    assertEquals(17, enough.of("BRK-1").orElseThrow().faults());
    reactions.remove(0);
    Diagnostic found = only(strength(alone, Set.of(), reactions));
    assertTrue(
        found
            .message()
            .contains(
                "3 of 7 standard faults of 'Brake' that count for the bound, without 9 of outputs that other requirements judge: 42.9 %"),
        found.message());
  }

  /** The components that count for a bound are in the results, and so is that no fault counts. */
  @Test
  void whatCountsForABoundIsAResult() {
    List<List<String>> upstream = List.of(List.of("Brake", "Radar"));
    List<Reaction> some = reactions("Brake", 4, 8);
    some.addAll(reactions("Radar", 0, 33));
    assertEquals(
        Optional.of(new Bound(50, List.of("Brake"), 4, 8, OptionalLong.empty())),
        strength(upstream, Set.of(), some).of("BRK-1").orElseThrow().bound());
    RequirementStrength none = strength(upstream, Set.of(), reactions("Radar", 1, 5));
    assertEquals(
        Optional.of(new Bound(50, List.of("Brake"), 0, 0, OptionalLong.empty())),
        none.of("BRK-1").orElseThrow().bound());
    Diagnostic found = only(none);
    assertEquals("simulation.strength.low", found.id());
    assertTrue(
        found.message().startsWith("No standard fault of 'Brake' counts for the bound of BRK-1"),
        found.message());
  }

  /** A bound says of how many faults those are a sample that it is compared with. */
  @Test
  void whatCountsForABoundMayBeASample() {
    Bound bound =
        strength(true, reactions("Brake", 3, 6), 4)
            .of("BRK-1")
            .flatMap(RequirementOutcome.Strength::bound)
            .orElseThrow();
    assertEquals(new Bound(50, List.of("Brake"), 3, 6, OptionalLong.of(10)), bound);
  }

  @Test
  void withoutABoundNothingCountsForOne() {
    Strength.Requirement measured =
        new Strength.Requirement(
            "BRK-1",
            List.of("Brake"),
            List.of(List.of("Brake")),
            Set.of(),
            true,
            reactions("Brake", 1, 8),
            List.of());
    RequirementStrength strength =
        new RequirementStrength(
            Optional.of(new Strength(List.of(measured), 8, 30, 8, 8)),
            StrengthSettings.DEFAULT,
            List.of());
    assertEquals(Optional.empty(), strength.of("BRK-1").orElseThrow().bound());
  }

  private static List<Reaction> reactions(String component, int noticed, int faults) {
    return IntStream.range(0, faults)
        .mapToObj(i -> reaction(component, i < noticed))
        .collect(Collectors.toCollection(ArrayList::new));
  }

  private static Reaction reaction(String component, boolean noticed) {
    return new Reaction(component, "fault", noticed, "far", "ego stops", Optional.empty(), false);
  }

  @Test
  void aSampleIsSaid() {
    Reaction noticed =
        new Reaction("Brake", "fault", true, "far", "ego stops", Optional.empty(), false);
    RequirementStrength sample = strength(true, List.of(noticed), 4);
    assertEquals(
        "notices 1 of 1 faults, a sample of 5",
        RequirementStrength.words(sample.of("BRK-1").orElseThrow()));
    assertEquals(
        "notices 1 of 1 faults",
        RequirementStrength.words(strength(true, true).of("BRK-1").orElseThrow()));
  }

  private static Diagnostic only(RequirementStrength strength) {
    assertEquals(1, strength.findings().size(), strength.findings().toString());
    return strength.findings().get(0);
  }

  private static RequirementStrength strength(boolean needed, Boolean... noticed) {
    List<Reaction> reactions =
        List.of(noticed).stream()
            .map(
                each ->
                    new Reaction(
                        "Brake", "fault", each, "far", "ego stops", Optional.empty(), false))
            .toList();
    return strength(needed, reactions, 0);
  }

  private static RequirementStrength strength(
      boolean needed, List<Reaction> reactions, int leftOut) {
    List<List<String>> alone = List.of(List.of("Brake"));
    return strength(needed, alone, Set.of("/emergency"), reactions, leftOut);
  }

  private static RequirementStrength strength(
      List<List<String>> branches, Set<String> outputs, List<Reaction> reactions) {
    return strength(true, branches, outputs, reactions, 0);
  }

  private static RequirementStrength strength(
      boolean needed,
      List<List<String>> branches,
      Set<String> outputs,
      List<Reaction> reactions,
      int leftOut) {
    List<String> components = branches.stream().flatMap(List::stream).toList();
    Strength.Requirement requirement =
        new Strength.Requirement(
            "BRK-1",
            components,
            branches,
            outputs,
            needed,
            reactions,
            Collections.nCopies(leftOut, new LeftOut("Brake", "/brake", false)));
    int tried = reactions.size();
    Strength measured = new Strength(List.of(requirement), tried, 30, tried, tried + leftOut);
    WrittenRequirement written =
        new WrittenRequirement(
            "BRK-1", "It brakes.", new SourceLocation("requirements.md", 3, 1, "", ""));
    return new RequirementStrength(Optional.of(measured), HALF, List.of(written));
  }
}
