package dev.eventchain.openscenario.storyboard.world;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;

/** Rules of the findings about storyboards. */
public final class StoryboardRules {

  public static final Rule UNSUPPORTED = Rule.error("storyboard.unsupported");
  public static final Rule UNKNOWN = Rule.error("storyboard.reference.unknown");
  public static final Rule AMBIGUOUS = Rule.error("storyboard.reference.ambiguous");
  public static final Rule VALUE = Rule.error("storyboard.value");
  public static final Rule OVERLAP = Rule.error("storyboard.overlap");
  public static final Rule UNPLACED = Rule.error("storyboard.entity.unplaced");
  public static final Rule ACTIVATED_LATER = Rule.warning("storyboard.controller.later");
  public static final Rule NO_ACTORS = Rule.warning("storyboard.actors.none");
  public static final Rule EMPTY_TRIGGER = Rule.warning("storyboard.trigger.empty");
  public static final Rule NO_PLACE = Rule.error("storyboard.place.none");
  public static final Rule ROUTE_SIDE = Rule.warning("storyboard.route.side");
  public static final Rule TRAJECTORY = Rule.error("storyboard.trajectory");
  public static final Rule CIRCLE = Rule.error("storyboard.init.circle");

  private StoryboardRules() {}

  /** Returns a failure of one finding. */
  public static DiagnosticException failure(
      Rule rule, String message, SourceLocation place, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS, Diagnostic.of(rule, message, place).withHint(hint));
  }
}
