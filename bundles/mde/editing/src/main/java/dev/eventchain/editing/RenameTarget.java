package dev.eventchain.editing;

/**
 * Thing that can be renamed at a position, or the reason why nothing can.
 *
 * @param range the name at the position; {@code null} if it cannot be renamed
 * @param name the name; empty if it cannot be renamed
 * @param refusal why it cannot be renamed, in a sentence; empty if it can
 */
public record RenameTarget(TextRange range, String name, String refusal) {

  /** Returns that a name can be renamed. */
  public static RenameTarget of(TextRange range, String name) {
    return new RenameTarget(range, name, "");
  }

  /** Returns why nothing can be renamed. */
  public static RenameTarget refused(String reason) {
    return new RenameTarget(null, "", reason);
  }

  /** Returns whether it can be renamed. */
  public boolean isAllowed() {
    return refusal.isEmpty();
  }
}
