package dev.eventchain.workspace.launch;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about launch files and files of parameters. */
public final class LaunchRules {

  public static final Rule LAUNCH = Rule.error("workspace.launch");

  private LaunchRules() {}
}
