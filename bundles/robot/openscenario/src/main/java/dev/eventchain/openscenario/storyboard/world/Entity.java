package dev.eventchain.openscenario.storyboard.world;

import dev.eventchain.openscenario.document.ScenarioElement;

/**
 * A scenario object.
 *
 * @param kind {@code vehicle}, {@code pedestrian}, {@code miscellaneous} or {@code external}
 * @param category the standard's category of its kind, such as {@code car}; empty for external ones
 * @param box its bounding box; of size 0 for external ones
 * @param mass in kg; 0 if it is not said
 * @param written the scenario object
 */
public record Entity(
    String name,
    String kind,
    String category,
    Box box,
    Performance performance,
    double mass,
    ScenarioElement written) {}
