package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.project.requirements.TrlcTokens.Kind;
import dev.eventchain.project.requirements.TrlcTokens.Token;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Reads the records of a {@code .trlc} file. Their ids are those of TRLC, with the package. */
final class TrlcReader {

  private final TrlcTokens tokens;
  private final TrlcTypes types;
  private final Reading reading;
  private String home = "";

  private TrlcReader(TrlcTokens tokens, TrlcTypes types, Reading reading) {
    this.tokens = tokens;
    this.types = types;
    this.reading = reading;
  }

  static void read(TrlcTokens tokens, TrlcTypes types, Reading reading) {
    new TrlcReader(tokens, types, reading).read();
  }

  private void read() {
    tokens.require("package");
    home = tokens.requireName();
    while (tokens.peek().kind() != Kind.END) {
      if (tokens.takeIf("import")) {
        tokens.requireName();
      } else {
        element();
      }
    }
  }

  private void element() {
    int open = 0;
    do {
      if (tokens.takeIf("section")) {
        tokens.skipText();
        tokens.require("{");
        open++;
      } else if (open > 0 && tokens.takeIf("}")) {
        open--;
      } else {
        record();
      }
    } while (open > 0);
  }

  private void record() {
    Token start = tokens.peek();
    String type = TrlcTypes.qualified(tokens.requireName(), home);
    Token name = tokens.requireWord();
    tokens.require("{");
    Map<String, List<Token>> values = new HashMap<>();
    while (!tokens.takeIf("}")) {
      Token field = tokens.requireWord();
      tokens.require("=");
      if (values.put(field.text(), value()) != null) {
        String message = "The field '" + field.text() + "' is given twice.";
        reading.unread(message, tokens.at(field), "Leave one of them out.");
      }
    }
    if (types.has(type)) {
      types.frozen(type).forEach(values::putIfAbsent);
      add(type, home + "." + name.text(), tokens.at(name), values);
    } else {
      reading.unread(
          "There is no type '" + type + "'.",
          tokens.at(start),
          "Its .rsl file has to be in the folder of the source, or below it.");
    }
  }

  /** Takes the tokens of a value: all before the next field or the end of the record. */
  private List<Token> value() {
    List<Token> value = new ArrayList<>();
    while (!tokens.peek().is("}") && !(tokens.peek().isWord() && tokens.peek(1).is("="))) {
      if (tokens.peek().kind() == Kind.END) {
        throw tokens.unexpected("'}'");
      }
      value.add(tokens.take());
    }
    return value;
  }

  private void add(
      String type, String name, SourceLocation place, Map<String, List<Token>> values) {
    RequirementSource.Fields names = reading.fields;
    String text =
        names.text().or(() -> types.textField(type)).map(each -> text(values, each)).orElse("");
    Item item = new Item(names.id().map(each -> text(values, each)).orElse(name), text, place);
    item.type = Optional.of(type.substring(type.lastIndexOf('.') + 1));
    item.generalTypes = types.names(type);
    item.status = word(values, names.status().orElse("status"));
    item.tags =
        values.getOrDefault(names.tags().orElse("tags"), List.of()).stream()
            .filter(token -> token.kind() == Kind.TEXT || token.isWord())
            .map(Token::text)
            .toList();
    for (String field : names.parents().isEmpty() ? types.references(type) : names.parents()) {
      for (Reference each : references(values.getOrDefault(field, List.of()))) {
        reading.refer(item, each.name(), tokens.at(each.start()));
      }
    }
    reading.addNamed(name, item);
  }

  private static String text(Map<String, List<Token>> values, String field) {
    return values.getOrDefault(field, List.of()).stream()
        .filter(token -> token.kind() == Kind.TEXT)
        .map(Token::text)
        .collect(Collectors.joining(" "));
  }

  /** Returns a text, or the literal of an enumeration. */
  private static Optional<String> word(Map<String, List<Token>> values, String field) {
    return values.getOrDefault(field, List.of()).stream()
        .filter(token -> token.kind() == Kind.TEXT || token.isWord())
        .map(Token::text)
        .reduce((before, last) -> last);
  }

  private record Reference(String name, Token start) {}

  private List<Reference> references(List<Token> value) {
    List<Reference> found = new ArrayList<>();
    for (int i = 0; i < value.size(); i++) {
      Token start = value.get(i);
      if (start.isWord() && !start.is("null")) {
        StringBuilder name = new StringBuilder(start.text());
        for (; i + 2 < value.size() && value.get(i + 1).is("."); i += 2) {
          name.append('.').append(value.get(i + 2).text());
        }
        found.add(new Reference(TrlcTypes.qualified(name.toString(), home), start));
      }
    }
    return found;
  }
}
