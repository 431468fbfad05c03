package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.world.Progress;

/**
 * A change of an element's state.
 *
 * @param time simulated time in s
 * @param path the names from the story to the element, separated by {@code /}
 * @param type the standard's name of its type, such as {@code maneuverGroup}
 * @param transition the transition; null for the begin of standby
 * @param state the state after it
 */
public record Change(
    double time, String path, String type, Progress.Transition transition, Progress.State state) {}
