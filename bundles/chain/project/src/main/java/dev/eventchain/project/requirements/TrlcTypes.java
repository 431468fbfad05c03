package dev.eventchain.project.requirements;

import dev.eventchain.project.requirements.TrlcTokens.Token;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/** The types of records that {@code .rsl} files declare. Checks and tuples are left out. */
final class TrlcTypes {

  private static final Set<String> TEXTS = Set.of("String", "Markup_String");

  /**
   * A type of records.
   *
   * @param name with its package
   * @param base the name of the type that it extends, with its package; empty if none
   * @param fields the names of their types, with packages, by the names of fields
   * @param frozen fixed values
   */
  private record Type(
      String name, String base, Map<String, String> fields, Map<String, List<Token>> frozen) {}

  private final Map<String, Type> types = new HashMap<>();

  /** Adds the declarations of a file. */
  void read(TrlcTokens tokens) {
    tokens.require("package");
    String home = tokens.requireName();
    while (tokens.peek().kind() != TrlcTokens.Kind.END) {
      if (tokens.takeIf("import")) {
        tokens.requireName();
      } else if (tokens.takeIf("enum") || tokens.takeIf("tuple") || tokens.takeIf("checks")) {
        tokens.requireName();
        tokens.skipText();
        tokens.skipBlock("{", "}");
      } else {
        while (tokens.takeIf("abstract") || tokens.takeIf("final")) {
          // whether there are records of it does not matter here
        }
        tokens.require("type");
        type(tokens, home);
      }
    }
  }

  private void type(TrlcTokens tokens, String home) {
    String name = home + "." + tokens.requireWord().text();
    tokens.skipText();
    String base = tokens.takeIf("extends") ? qualified(tokens.requireName(), home) : "";
    tokens.skipText();
    Type type = new Type(name, base, new LinkedHashMap<>(), new HashMap<>());
    tokens.require("{");
    while (!tokens.takeIf("}")) {
      if (tokens.takeIf("freeze")) {
        String field = tokens.requireWord().text();
        tokens.require("=");
        type.frozen().put(field, frozenValue(tokens));
      } else {
        field(tokens, home, type);
      }
    }
    types.put(name, type);
  }

  private static void field(TrlcTokens tokens, String home, Type type) {
    String field = tokens.requireWord().text();
    tokens.skipText();
    tokens.takeIf("optional");
    String kind;
    if (tokens.takeIf("[")) { // one of several types
      kind = qualified(tokens.requireName(), home);
      while (tokens.takeIf(",")) {
        tokens.requireName();
      }
      tokens.require("]");
    } else {
      kind = qualified(tokens.requireName(), home);
    }
    type.fields().put(field, kind);
    if (tokens.peek().is("[")) {
      tokens.skipBlock("[", "]");
    }
  }

  /** Takes the tokens of a fixed value. */
  private static List<Token> frozenValue(TrlcTokens tokens) {
    List<Token> value = new ArrayList<>();
    for (int depth = 0; ; ) {
      if (tokens.peek().kind() == TrlcTokens.Kind.END) {
        throw tokens.unexpected("a value");
      }
      Token taken = tokens.take();
      value.add(taken);
      depth += taken.is("[") || taken.is("(") ? 1 : taken.is("]") || taken.is(")") ? -1 : 0;
      boolean goesOn = taken.is(".") || taken.is("-") || tokens.peek().is(".");
      if (depth <= 0 && !goesOn) {
        return value;
      }
    }
  }

  static String qualified(String name, String home) {
    boolean builtIn =
        TEXTS.contains(name) || Set.of("Integer", "Decimal", "Boolean").contains(name);
    return builtIn || name.contains(".") ? name : home + "." + name;
  }

  boolean has(String type) {
    return types.containsKey(type);
  }

  /** Returns a type and those that it extends, itself first. */
  private List<Type> line(String type) {
    Map<String, Type> line = new LinkedHashMap<>();
    for (Type each = types.get(type); each != null; each = types.get(each.base())) {
      if (line.putIfAbsent(each.name(), each) != null) {
        break; // they extend each other
      }
    }
    return List.copyOf(line.values());
  }

  /** Returns the names of a type and of those that it extends, with and without package. */
  Set<String> names(String type) {
    Set<String> names = new LinkedHashSet<>();
    for (Type each : line(type)) {
      names.add(each.name());
      names.add(each.name().substring(each.name().lastIndexOf('.') + 1));
    }
    return names;
  }

  /** Returns the fixed values of a type. */
  Map<String, List<Token>> frozen(String type) {
    Map<String, List<Token>> frozen = new HashMap<>();
    line(type).forEach(each -> each.frozen().forEach(frozen::putIfAbsent));
    return frozen;
  }

  /** Returns the usual field of a text: a known name, or the only text that there is. */
  Optional<String> textField(String type) {
    List<String> texts = fields(type, TEXTS::contains);
    return texts.stream()
        .filter(each -> each.matches("(?i)description|text|statement|content"))
        .findFirst()
        .or(() -> texts.size() == 1 ? Optional.of(texts.get(0)) : Optional.empty());
  }

  /** Returns the fields that refer to records. */
  List<String> references(String type) {
    return fields(type, types::containsKey);
  }

  private List<String> fields(String type, Predicate<String> kind) {
    List<String> fields = new ArrayList<>();
    List<Type> line = line(type);
    for (int i = line.size() - 1; i >= 0; i--) {
      line.get(i)
          .fields()
          .forEach(
              (name, declared) -> {
                if (kind.test(declared)) {
                  fields.add(name);
                }
              });
    }
    return fields;
  }
}
