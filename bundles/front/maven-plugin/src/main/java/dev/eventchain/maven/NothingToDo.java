package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.File;
import java.util.Optional;

/** Findings about goals without any work, which would prove nothing. */
final class NothingToDo {

  private NothingToDo() {}

  /**
   * Returns the finding.
   *
   * @param place the folder that was searched, if any
   */
  static Diagnostic finding(String message, Optional<File> place) {
    return Diagnostic.of(
            GoalRules.NOTHING_TO_CHECK,
            message,
            place.map(Places::shown).map(SourceLocation::of).orElse(SourceLocation.NONE))
        .withHint(
            "Name models with <models>, or a project with <chain>; if none are needed, set"
                + " <allowEmpty>true</allowEmpty>, or <skip>true</skip>.");
  }
}
