package dev.eventchain.constraints.editing;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.editing.Call;
import dev.eventchain.editing.FileRange;
import dev.eventchain.editing.InlayHint;
import dev.eventchain.editing.TextLines;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.assist.AssistedText;
import dev.eventchain.ocl.editing.Mention;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;

/** A text whose names are declared in metamodels and in rule documents. */
abstract class DeclaredText extends AssistedText {

  private final RuleDeclarations declarations;
  private final RuleLanguageService service;

  DeclaredText(
      Path file,
      SourceText source,
      TextLines lines,
      RuleDeclarations declarations,
      RuleLanguageService service) {
    super(file, source, lines);
    this.declarations = declarations;
    this.service = service;
  }

  final RuleDeclarations declarations() {
    return declarations;
  }

  final ExpressionLanguage language() {
    return declarations.world().language();
  }

  /** Returns where a class and those below it are declared. */
  final List<FileRange> declarationsBelow(EClass type) {
    return language().packages().classesBelow(type).stream()
        .flatMap(each -> declaration(each).stream())
        .toList();
  }

  @Override
  protected final List<AssistedText> family() {
    return service.family(this);
  }

  @Override
  protected final Optional<FileRange> declaration(Object target) {
    return declarations.of(target);
  }

  @Override
  protected final boolean isOwn(Object target) {
    return declarations.isOwn(target);
  }

  @Override
  protected final String describe(Mention mention) {
    return declarations.describe(mention);
  }

  @Override
  protected final String collision(Object target, String newName) {
    return declarations.collision(target, newName);
  }

  @Override
  protected final Optional<Call.Item> itemOf(Object target) {
    return declarations.item(target);
  }

  @Override
  protected final List<InlayHint> outerHints(int start, int end) {
    return List.of();
  }
}
