package dev.eventchain.pipeline.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.pipeline.project.StrengthExtent;
import dev.eventchain.pipeline.project.StrengthSettings;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.verdict.Strength.Reaction;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
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
    assertTrue(found.message().contains("1 of 3"), found.message());
    assertTrue(!strength.isUntested("BRK-1"));
  }

  @Test
  void aDesignMayLetFurtherComponentsContribute() {
    List<Reaction> half = List.of(reaction("Brake", true), reaction("Brake", false));
    List<Reaction> more = new ArrayList<>(half);
    more.addAll(List.of(reaction("Radar", false), reaction("Radar", false)));
    assertTrue(strength(true, half, 0).findings().isEmpty());
    assertTrue(strength(true, more, 0).findings().isEmpty());
    more.add(reaction("Brake", false));
    Diagnostic found = only(strength(true, more, 0));
    assertEquals("simulation.strength.low", found.id());
    assertTrue(found.message().contains("1 of 3 standard faults of 'Brake'"), found.message());
  }

  private static Reaction reaction(String component, boolean noticed) {
    return new Reaction(component, "fault", noticed, "far", "ego stops", Optional.empty());
  }

  @Test
  void aSampleIsSaid() {
    Reaction noticed = new Reaction("Brake", "fault", true, "far", "ego stops", Optional.empty());
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
            .map(each -> new Reaction("Brake", "fault", each, "far", "ego stops", Optional.empty()))
            .toList();
    return strength(needed, reactions, 0);
  }

  private static RequirementStrength strength(
      boolean needed, List<Reaction> reactions, int leftOut) {
    List<String> components =
        Stream.concat(Stream.of("Brake"), reactions.stream().map(Reaction::component))
            .distinct()
            .toList();
    Strength.Requirement requirement =
        new Strength.Requirement(
            "BRK-1", components, Set.of("/emergency"), needed, reactions, leftOut);
    int tried = reactions.size();
    Strength measured = new Strength(List.of(requirement), tried, 30, tried, tried + leftOut);
    WrittenRequirement written =
        new WrittenRequirement(
            "BRK-1", "It brakes.", new SourceLocation("requirements.md", 3, 1, "", ""));
    return new RequirementStrength(Optional.of(measured), HALF, List.of(written));
  }
}
