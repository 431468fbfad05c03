package dev.eventchain.ocl;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;

/** Definitions for the languages of tests. */
final class TestDefinitions {

  private TestDefinitions() {}

  /** Adds definitions without errors to a class. */
  static void define(ExpressionLanguage language, EClassifier owner, List<String> texts) {
    List<Diagnostic> problems = new ArrayList<>();
    Scope scope = language.root().in(owner.getEPackage()).with("self", owner);
    new Definitions(language, problems)
        .addAll(texts.stream().map(text -> definition(text, scope)).toList());
    assertEquals(List.of(), problems);
  }

  static Definitions.Definition definition(String text, Scope scope) {
    SourceRange whole = SourceText.of("definitions.ocl", text).whole();
    return new Definitions.Definition(whole, scope, whole.location());
  }
}
