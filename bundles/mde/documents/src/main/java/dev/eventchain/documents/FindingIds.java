package dev.eventchain.documents;

/**
 * Ids of the findings about a kind of file.
 *
 * @param syntax a text that is not JSON or YAML, or uses unsupported features
 * @param duplicate a duplicate key in an object
 * @param type a value of the wrong type
 * @param missing a missing required value
 * @param unknown an unknown key
 * @param range a value of the right type that is out of range
 */
public record FindingIds(
    String syntax, String duplicate, String type, String missing, String unknown, String range) {

  /** Returns ids that are all the same. */
  public static FindingIds all(String id) {
    return new FindingIds(id, id, id, id, id, id);
  }
}
