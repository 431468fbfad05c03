package dev.eventchain.messages;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;

/**
 * A parsed message definition, before the types of its fields are resolved.
 *
 * @param problems errors in the definition
 */
record Definition(
    String name, List<Member> fields, List<Member> constants, List<Diagnostic> problems) {

  /**
   * A field or a constant.
   *
   * @param type its type; a message type is unresolved and named by {@code base}
   * @param base the full name of a message type, or the primitive type
   * @param value the value of a constant or the default of a field; null if there is none
   * @param place the location of its type
   */
  record Member(String name, FieldType type, String base, Object value, SourceLocation place) {

    /**
     * Returns the content regardless of locations; IDL writes {@code char} as {@code uint8}
     * (rosidl).
     */
    private List<Object> meaning() {
      boolean isChar = type.kind() == FieldType.Kind.CHAR;
      return List.of(
          name,
          isChar ? FieldType.Kind.UINT8 : type.kind(),
          isChar ? "uint8" : base,
          type.shape(),
          type.size(),
          type.stringBound());
    }

    private boolean saysTheSameAs(Member other) {
      return meaning().equals(other.meaning()) && Objects.deepEquals(value, other.value);
    }
  }

  /**
   * Returns this definition if it has no errors.
   *
   * @throws DiagnosticException with its problems
   */
  Definition orThrow() {
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return this;
  }

  /** Returns whether both have the same fields in the same order, and the same constants. */
  boolean saysTheSameAs(Definition other) {
    return sameMembers(fields, other.fields)
        && sameMembers(byName(constants), byName(other.constants));
  }

  private static List<Member> byName(List<Member> members) {
    return members.stream().sorted(Comparator.comparing(Member::name)).toList();
  }

  private static boolean sameMembers(List<Member> ones, List<Member> others) {
    boolean same = ones.size() == others.size();
    for (int i = 0; same && i < ones.size(); i++) {
      same = ones.get(i).saysTheSameAs(others.get(i));
    }
    return same;
  }
}
