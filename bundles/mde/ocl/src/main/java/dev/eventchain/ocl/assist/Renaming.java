package dev.eventchain.ocl.assist;

import dev.eventchain.editing.FileEdit;
import dev.eventchain.editing.FileRange;
import dev.eventchain.ocl.editing.Mention;
import dev.eventchain.ocl.editing.Mention.Kind;
import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.text.Tokens;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** Facts that renaming needs: which names are possible, and what a new one would hide. */
public final class Renaming {

  private Renaming() {}

  /** Returns whether a text can be the name of something. */
  public static boolean isName(String text) {
    return text.matches("[A-Za-z_]\\w*")
        && !Keywords.ALL.contains(text)
        && !Keywords.TYPES.contains(text)
        && !text.equals("self");
  }

  /** Returns the edits at some places, in their order. */
  static List<FileEdit> edits(List<FileRange> places, String newName) {
    return places.stream()
        .sorted(
            Comparator.comparing((FileRange each) -> each.file())
                .thenComparing(each -> each.range().start()))
        .map(each -> new FileEdit(each.file(), each.range(), newName))
        .toList();
  }

  /** Returns why a variable cannot get a name; empty if it can. */
  static String collision(
      Mention variable, String newName, List<ExpressionPlace> places, List<Mention> outer) {
    for (ExpressionPlace place : places) {
      List<Mention> mentions = place.mentions();
      boolean declares =
          mentions.stream()
              .anyMatch(each -> each.declaredAt() == variable.declaredAt() && isVariable(each));
      boolean sees = place.scope().offsetOf(variable.name()) == variable.declaredAt();
      if (declares || sees) {
        String reason = collision(variable, newName, place, mentions);
        if (!reason.isEmpty()) {
          return reason;
        }
      }
    }
    boolean beside =
        outer.stream()
            .anyMatch(each -> isVariable(each) && isNear(each, variable, places, newName));
    return beside ? already(newName) : "";
  }

  /** Returns why a feature that is named without its object cannot get a name; empty if it can. */
  static String capture(Set<Object> targets, String newName, List<? extends AssistedText> texts) {
    for (AssistedText text : texts) {
      for (ExpressionPlace place : text.places()) {
        List<Mention> mentions = place.mentions();
        boolean named =
            mentions.stream()
                .filter(each -> each.kind() == Kind.FEATURE && targets.contains(each.target()))
                .anyMatch(each -> !isAfterNavigation(text.source().text(), each.start()));
        boolean hidden =
            place.scope().typeOf(newName) != null
                || mentions.stream()
                    .anyMatch(each -> isVariable(each) && each.name().equals(newName));
        if (named && hidden) {
          return "A variable '%s' would be meant instead, at %s."
              .formatted(newName, place.range().location());
        }
      }
    }
    return "";
  }

  /** Returns whether both variables are visible in an expression. */
  private static boolean isNear(
      Mention other, Mention variable, List<ExpressionPlace> places, String newName) {
    return other.name().equals(newName)
        && places.stream()
            .anyMatch(
                each ->
                    each.scope().offsetOf(newName) == other.declaredAt()
                        && each.scope().offsetOf(variable.name()) == variable.declaredAt());
  }

  private static String collision(
      Mention variable, String newName, ExpressionPlace place, List<Mention> mentions) {
    if (place.scope().typeOf(newName) != null
        || mentions.stream().anyMatch(each -> isVariable(each) && each.name().equals(newName))) {
      return already(newName);
    }
    String text = place.range().source().text();
    boolean hides =
        mentions.stream()
            .filter(each -> each.name().equals(newName) && !isVariable(each))
            .anyMatch(each -> !isAfterNavigation(text, each.start()));
    if (hides) {
      return "'" + newName + "' would hide what has this name in the same expression.";
    }
    return isMissed(variable, place, mentions)
        ? "An expression that may use '%s' has an error, at %s: correct it first."
            .formatted(variable.name(), place.range().location())
        : "";
  }

  private static String already(String newName) {
    return "There is already a variable '" + newName + "' here.";
  }

  /** Returns whether the name stands in an expression where its meaning is not known. */
  private static boolean isMissed(Mention variable, ExpressionPlace place, List<Mention> mentions) {
    Tokens tokens = new Tokens(place.range().text());
    int start = place.range().start();
    for (int i = 0; i < tokens.size(); i++) {
      int at = start + tokens.start(i);
      if (tokens.is(i, variable.name())
          && !isAfterNavigation(place.range().source().text(), at)
          && mentions.stream().noneMatch(each -> each.start() == at)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isAfterNavigation(String text, int offset) {
    String before = text.substring(0, offset).stripTrailing();
    return Stream.of(".", "->", "::").anyMatch(before::endsWith);
  }

  private static boolean isVariable(Mention mention) {
    return mention.kind() == Kind.VARIABLE || mention.kind() == Kind.DECLARATION;
  }
}
