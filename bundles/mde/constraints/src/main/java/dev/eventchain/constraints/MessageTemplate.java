package dev.eventchain.constraints;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.eclipse.emf.common.util.Enumerator;
import org.eclipse.emf.ecore.EObject;

/** A message with expressions in braces, evaluated on the element of the finding. */
final class MessageTemplate {

  /** A piece of text, or an expression. */
  private record Part(String text, Expression expression) {}

  private final List<Part> parts;

  private MessageTemplate(List<Part> parts) {
    this.parts = parts;
  }

  /**
   * Reads a message.
   *
   * @param text the message; empty for none
   * @param firstLine its first line as written; the others are indented there but not in text
   */
  static Optional<MessageTemplate> parse(
      String text,
      SourceRange firstLine,
      Scope scope,
      ExpressionLanguage language,
      List<Diagnostic> problems) {
    List<Part> parts = new ArrayList<>();
    int at = 0;
    while (at < text.length()) {
      int open = text.indexOf('{', at);
      int close = open < 0 ? -1 : closingBrace(text, open);
      if (open < 0 || close < 0) {
        break;
      }
      parts.add(new Part(text.substring(at, open), null));
      SourceRange where = firstLine;
      if (firstLine.start() + close > firstLine.end()) {
        where = SourceText.of(firstLine.source().name(), text).whole();
      }
      SourceRange inside = where.source().range(where.start() + open + 1, where.start() + close);
      language
          .parse(inside, scope, problems)
          .ifPresent(expression -> parts.add(new Part("", expression)));
      at = close + 1;
    }
    parts.add(new Part(text.substring(at), null));
    return text.isEmpty() ? Optional.empty() : Optional.of(new MessageTemplate(parts));
  }

  /** Reads a message that is an expression as a whole. */
  static Optional<MessageTemplate> parse(
      SourceRange expression, Scope scope, ExpressionLanguage language, List<Diagnostic> problems) {
    return language
        .parse(expression, scope, problems)
        .map(parsed -> new MessageTemplate(List.of(new Part("", parsed))));
  }

  private static int closingBrace(String text, int open) {
    Tokens tokens = new Tokens(text.substring(open));
    int closing = tokens.closing(0, "{", "}");
    return closing == tokens.size() ? -1 : open + tokens.start(closing);
  }

  /** Returns the expressions in braces. */
  List<Expression> expressions() {
    return parts.stream().map(Part::expression).filter(Objects::nonNull).toList();
  }

  /** Returns the message about the element that the run has bound to {@code self}. */
  String render(Evaluation run) {
    StringBuilder result = new StringBuilder();
    for (Part part : parts) {
      result.append(
          part.expression() == null ? part.text() : text(part.expression().evaluate(run)));
    }
    return result.toString();
  }

  private static String text(Object value) {
    if (value instanceof Invalid) {
      return "(undefined)";
    } else if (value instanceof Enumerator literal) {
      return literal.getName();
    } else if (value instanceof EObject object) {
      return Names.label(object);
    } else if (value instanceof Collection<?> elements) {
      return elements.stream().map(MessageTemplate::text).collect(Collectors.joining(", "));
    }
    return String.valueOf(value);
  }
}
