package dev.eventchain.documents;

/**
 * The ids under which a kind of file reports what is wrong with it.
 *
 * @param syntax it is not JSON or YAML, or uses what is not read
 * @param duplicate a key is duplicated in an object
 * @param type a value is of another type than the one that is meant
 * @param missing something that is needed is not there
 * @param unknown a key that no reader asks for
 * @param range a value of the right type that cannot be
 */
public record FindingIds(
    String syntax, String duplicate, String type, String missing, String unknown, String range) {

  /** One id for all that can be wrong. */
  public static FindingIds all(String id) {
    return new FindingIds(id, id, id, id, id, id);
  }
}
