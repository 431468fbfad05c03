package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Happened;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Tests what a storyboard let happen, and when. */
class WhatHappenedTest {

  private static final Path SCENARIO = Path.of("src/test/resources/openscenario/s.yaml");

  private static List<String> happened(String situation, double duration, long braking) {
    String text = "name: a\ntitle: A\n%saccept: {no_impact: true}\n".formatted(situation);
    Scenario scenario = Scenario.parse(SourceText.of(SCENARIO.toString(), text), Bench.carla());
    World world = new World(scenario.situation(), new Trace(Map.of(), scenario.situation().road()));
    world.advanceTo(braking * 1_000_000_000);
    world.command(world.now(), VehicleCommand.brake(1.0));
    world.advanceTo(World.nanoseconds(duration));
    return WhatHappened.happened(scenario, world.trace()).stream()
        .map(WhatHappenedTest::words)
        .toList();
  }

  private static String words(Happened each) {
    String end =
        each.end().isPresent()
            ? String.format(Locale.ROOT, " to %.1f", each.end().getAsDouble())
            : "";
    return String.format(Locale.ROOT, "%s %s: %.1f%s", each.kind(), each.name(), each.start(), end);
  }

  private static String played(String parameters) {
    return "openscenario: {file: rear-end.xosc, parameters: {%s}}\n".formatted(parameters);
  }

  @Test
  void eventsTheTakeoverAndTheEndAreInTheOrderOfTime() {
    String brakes = "brakes_at: 2, target_kph: 36, speed_kph: 36";
    assertEquals(
        List.of(
            "EVENT target brakes: 2.0 to 4.2",
            "TAKEOVER the software takes the pedals: 3.2",
            "END the storyboard ends: 4.2"),
        happened(played(brakes), 60, 3));
  }

  @Test
  void whatLastsBeyondTheEndOfTheRunHasNoEnd() {
    String brakes = "brakes_at: 2, target_kph: 36, speed_kph: 36";
    assertEquals(
        List.of("EVENT target brakes: 2.0"), happened(played(brakes) + "duration_s: 3\n", 3, 3));
  }

  @Test
  void whereNoStoryboardIsNothingHappens() {
    String own = "duration_s: 4\nego: {speed_kmh: 36}\nactors: [{gap_m: 20, speed_kmh: 36}]\n";
    assertEquals(List.of(), happened(own, 4, 1));
  }
}
