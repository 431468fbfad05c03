package dev.eventchain.editing;

import java.util.List;

/**
 * The edits that give something another name everywhere.
 *
 * @param edits the edits, by files and then by positions; empty if it is refused
 * @param refusal why it is not done, in a sentence; empty if it is
 */
public record Rename(List<FileEdit> edits, String refusal) {

  /** Returns a renaming by edits. */
  public static Rename of(List<FileEdit> edits) {
    return new Rename(List.copyOf(edits), "");
  }

  /** Returns why a renaming is not done. */
  public static Rename refused(String reason) {
    return new Rename(List.of(), reason);
  }

  /** Returns whether it is done. */
  public boolean isAllowed() {
    return refusal.isEmpty();
  }
}
