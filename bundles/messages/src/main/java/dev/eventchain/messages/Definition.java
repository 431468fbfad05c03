package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;

/**
 * A message definition as it was read, before the types of its fields are looked up.
 *
 * @param problems what is wrong with it
 */
record Definition(
    String name, List<Member> fields, List<Member> constants, List<Diagnostic> problems) {

  /**
   * A field or a constant.
   *
   * @param type its type; a message type is only named, by {@code base}
   * @param base the full name of a message type, or the primitive type
   * @param value the value of a constant or the default of a field; null if there is none
   * @param place where its type stands
   */
  record Member(String name, FieldType type, String base, Object value, SourceLocation place) {}
}
