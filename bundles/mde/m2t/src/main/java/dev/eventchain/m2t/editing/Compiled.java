package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.compile.ExpressionListener;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.assist.ExpressionPlace;
import dev.eventchain.ocl.assist.TypeNames;
import dev.eventchain.ocl.editing.Mention;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClassifier;

/** Results of the compiler for a template or a query: its expressions, variables and scopes. */
final class Compiled implements ExpressionListener {

  /** A variable that is declared without its type, and that type. */
  record Untyped(int end, EClassifier type) {}

  private final ExpressionLanguage language;
  private final List<ExpressionPlace> places = new ArrayList<>();
  private final List<Mention> names = new ArrayList<>();
  private final List<Untyped> untyped = new ArrayList<>();
  private final Map<Integer, Scope> bodies = new HashMap<>();

  Compiled(ExpressionLanguage language) {
    this.language = language;
  }

  @Override
  public void expression(SourceRange span, Scope scope) {
    places.add(new ExpressionPlace(span, scope, language.assistant()));
  }

  @Override
  public void type(SourceRange span) {
    names.addAll(TypeNames.in(span, language.packages()));
  }

  @Override
  public void variable(Syntax.Variable variable, EClassifier type) {
    Syntax.Name name = variable.name();
    names.add(declaration(name, type));
    if (variable.type().isEmpty()) {
      untyped.add(new Untyped(name.start() + name.text().length(), type));
    }
  }

  /** Returns the mention of a variable where it is declared. */
  static Mention declaration(Syntax.Name name, EClassifier type) {
    int end = name.start() + name.text().length();
    return new Mention(
        name.start(), end, Mention.Kind.DECLARATION, name.text(), null, type, null, name.start());
  }

  @Override
  public void body(int start, Scope scope) {
    bodies.put(start, scope);
  }

  /** Returns the expressions, in the order of the text. */
  List<ExpressionPlace> places() {
    return places.stream().sorted(Comparator.comparingInt(each -> each.range().start())).toList();
  }

  /** Returns the variables and the names of types outside expressions. */
  List<Mention> names() {
    return names;
  }

  List<Untyped> untyped() {
    return untyped;
  }

  /** Returns the scope of the body after a tag, or that around it if the tag declares nothing. */
  Scope scopeAfter(int start, Scope around) {
    return bodies.getOrDefault(start, around);
  }
}
