package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.Environment;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * Adds operations and properties to the classes of a language: first the signatures of all, then
 * their bodies, so that they may call each other in any order, also mutually. Users of a definition
 * with an error become unusable without an error of their own.
 */
public final class Definitions {

  /**
   * A definition: {@code def: name(parameter : Type) : Type = expression}.
   *
   * @param text the whole definition, from {@code def} or {@code static} on
   * @param scope the scope, in which {@code self} has the class to extend
   * @param location the place of findings about it
   */
  public record Definition(SourceRange text, Scope scope, SourceLocation location) {

    private EClassifier owner() {
      return scope.typeOf(Environment.SELF_VARIABLE_NAME);
    }

    private Tokens tokens() {
      return new Tokens(text.text());
    }

    /** Returns whether another one is the same in another document, which is no fault. */
    private boolean repeats(Definition other) {
      return text.source() != other.text.source()
          && tokens().words().equals(other.tokens().words());
    }
  }

  /** A definition whose signature is known. */
  private record Declared(Definition definition, SourceRange body, Object feature) {}

  private static final String STATIC = "static";

  private final ExpressionLanguage language;
  private final List<Diagnostic> problems;
  private final Map<String, Definition> names = new HashMap<>();
  private final List<Declared> declared = new ArrayList<>();

  /**
   * Definitions for a language.
   *
   * @param problems the list to add all errors and warnings to
   */
  public Definitions(ExpressionLanguage language, List<Diagnostic> problems) {
    this.language = language;
    this.problems = problems;
  }

  /** Adds definitions to their classes. */
  public void addAll(List<Definition> definitions) {
    for (Definition each : definitions) {
      DiagnosticException.runAt(each.location(), () -> declare(each));
    }
    for (Declared each : declared) {
      DiagnosticException.runAt(each.definition().location(), () -> complete(each));
    }
    spoilUsers();
  }

  /**
   * Adds the signatures of definitions to their classes, without their values, for editors.
   *
   * @return the operations and properties with their definitions
   */
  public Map<Object, Definition> declareAll(List<Definition> definitions) {
    definitions.forEach(this::declare);
    Map<Object, Definition> features = new LinkedHashMap<>();
    declared.forEach(each -> features.put(each.feature(), each.definition()));
    return features;
  }

  /** Marks the users of unusable definitions as unusable. */
  private void spoilUsers() {
    Map<Object, List<Declared>> users = new HashMap<>();
    Deque<Declared> unusable = new ArrayDeque<>();
    for (Declared each : declared) {
      OCLExpression<EClassifier> body = bodyOf(each.feature());
      if (body == null) {
        unusable.add(each);
      } else {
        for (Object used : Navigations.definitionsIn(body, language.environment())) {
          users.computeIfAbsent(used, none -> new ArrayList<>()).add(each);
        }
      }
    }
    while (!unusable.isEmpty()) {
      for (Declared user : users.getOrDefault(unusable.remove().feature(), List.of())) {
        if (bodyOf(user.feature()) != null) {
          language
              .environment()
              .getDefinition(user.feature())
              .getSpecification()
              .setBodyExpression(null);
          unusable.add(user);
        }
      }
    }
  }

  /** Records the name of a definition whose class is unknown, so that its uses give no errors. */
  public void addHomeless(SourceRange text) {
    language.environment().addFailedName(nameOf(new Tokens(text.text())));
  }

  private OCLExpression<EClassifier> bodyOf(Object feature) {
    return language.environment().getDefinition(feature).getSpecification().getBodyExpression();
  }

  /** Removes definitions with errors, so that expressions parsed later cannot use them. */
  public void forgetUnusable() {
    for (Declared each : declared) {
      if (bodyOf(each.feature()) == null) {
        language.environment().undefine(each.feature());
      }
    }
    language.environment().forgetFailedNames();
  }

  /** Returns whether all definitions that an expression uses have a body. */
  public boolean isUsable(Expression expression) {
    return Navigations.definitionsIn(expression.ast(), language.environment()).stream()
        .allMatch(each -> bodyOf(each) != null);
  }

  private void declare(Definition definition) {
    Tokens tokens = definition.tokens();
    int equals = equalsSign(tokens);
    Optional<Diagnostic> problem = shapeProblem(definition, tokens, equals);
    if (problem.isPresent()) {
      problems.add(problem.get());
      language.environment().addFailedName(nameOf(tokens));
    } else if (!isRepeated(definition, tokens, equals)) {
      SourceRange text = definition.text();
      int end = text.start() + tokens.end(equals);
      boolean isStatic = tokens.is(0, STATIC);
      int start = text.start() + tokens.start(isStatic ? 1 : 0);
      SourceRange signature = text.source().range(start, end);
      SourceRange body = text.source().range(end, text.end());
      int before = problems.size();
      language
          .declare(signature, definition.scope(), problems)
          .ifPresentOrElse(
              feature -> {
                declared.add(new Declared(definition, body, feature));
                if (isStatic) {
                  language.environment().addStatic(feature);
                }
              },
              () -> fail(definition, tokens, before));
    }
  }

  /** Reports a definition that cannot be declared, if no error has been reported for it. */
  private void fail(Definition definition, Tokens tokens, int before) {
    language.environment().addFailedName(nameOf(tokens));
    if (!Diagnostic.anyError(problems.subList(before, problems.size()))) {
      problems.add(
          Diagnostic.of(
                  ExpressionRules.SYNTAX, "This definition cannot be read.", definition.location())
              .withHint("Write def: name(parameter : Type) : Type = ..."));
    }
  }

  /** Returns the finding for a mistake that Eclipse OCL would report in unhelpful words. */
  private static Optional<Diagnostic> shapeProblem(
      Definition definition, Tokens tokens, int equals) {
    SourceRange text = definition.text();
    if (equals == tokens.size()) {
      return Optional.of(
          Diagnostic.of(
                  ExpressionRules.SYNTAX,
                  "A definition needs '=' and an expression.",
                  text.source().at(text.end()))
              .withHint("Write def: name : Type = ..."));
    } else if (untypedParameter(tokens, equals) >= 0) {
      int at = text.start() + tokens.start(untypedParameter(tokens, equals));
      return Optional.of(
          Diagnostic.of(ExpressionRules.SYNTAX, "A parameter needs a type.", text.source().at(at))
              .withHint("Write def: name(parameter : Type) : Type = ..."));
    } else if (typeColon(tokens, equals) < 0) {
      int at = text.start() + tokens.start(equals);
      return Optional.of(
          Diagnostic.of(
                  ExpressionRules.SYNTAX,
                  "A definition needs a type before '='.",
                  text.source().at(at))
              .withHint("Write def: name : Type = ..."));
    }
    return Optional.empty();
  }

  /** Returns the index of a parameter without a type; -1 if there is none. */
  private static int untypedParameter(Tokens tokens, int equals) {
    int colon = 0;
    while (colon < equals && !tokens.is(colon, ":")) {
      colon++;
    }
    int open = colon + 2; // after the name
    int depth = tokens.is(open, "(") ? 1 : 0;
    for (int i = open + 1; i < equals && depth > 0; i++) {
      boolean begins = depth == 1 && (i == open + 1 || tokens.is(i - 1, ","));
      if (begins && tokens.isName(i) && !tokens.is(i + 1, ":")) {
        return i;
      }
      depth += tokens.is(i, "(") ? 1 : tokens.is(i, ")") ? -1 : 0;
    }
    return -1;
  }

  /** Returns the index of the colon after the name and the parameters; -1 if there is none. */
  private static int typeColon(Tokens tokens, int equals) {
    int depth = 0;
    int colons = 0;
    for (int i = 0; i < equals; i++) {
      depth += tokens.is(i, "(") ? 1 : tokens.is(i, ")") ? -1 : 0;
      colons += depth == 0 && tokens.is(i, ":") ? 1 : 0;
      if (colons == 2) {
        return i;
      }
    }
    return -1;
  }

  /** Returns the index of the first {@code =} outside parentheses; the number of tokens if none. */
  private static int equalsSign(Tokens tokens) {
    int depth = 0;
    for (int i = 0; i < tokens.size(); i++) {
      depth += tokens.is(i, "(") ? 1 : tokens.is(i, ")") ? -1 : 0;
      if (depth == 0 && tokens.is(i, "=")) {
        return i;
      }
    }
    return tokens.size();
  }

  /** Returns the name of the feature, which follows the first colon. */
  private static String nameOf(Tokens tokens) {
    for (int i = 0; i + 1 < tokens.size(); i++) {
      if (tokens.is(i, ":")) {
        return tokens.text(i + 1);
      }
    }
    return "";
  }

  private boolean isRepeated(Definition definition, Tokens tokens, int equals) {
    int colon = 0;
    while (colon < equals && !tokens.is(colon, ":")) {
      colon++;
    }
    String signature = Names.qualified(definition.owner()) + " " + tokens.words(colon, equals);
    Definition first = names.putIfAbsent(signature, definition);
    if (first == null) {
      return false;
    } else if (!definition.repeats(first)) {
      problems.add(
          Diagnostic.of(
                  ExpressionRules.DUPLICATE,
                  "The definition '"
                      + nameOf(tokens)
                      + "' of "
                      + definition.owner().getName()
                      + " is declared twice.",
                  definition.location())
              .withHint("Give one of them another name.")
              .withRelated(first.location()));
    }
    return true;
  }

  private void complete(Declared each) {
    language.complete(each.feature(), each.body(), each.definition().scope(), problems);
  }
}
