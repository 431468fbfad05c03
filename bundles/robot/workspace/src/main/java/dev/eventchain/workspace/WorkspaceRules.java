package dev.eventchain.workspace;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about workspaces. */
final class WorkspaceRules {

  static final Rule EMPTY = Rule.error("workspace.empty");
  static final Rule NODL = Rule.error("workspace.nodl");
  static final Rule RECORDING = Rule.error("workspace.recording");
  static final Rule UNREAD = Rule.error("workspace.unread");

  private WorkspaceRules() {}
}
