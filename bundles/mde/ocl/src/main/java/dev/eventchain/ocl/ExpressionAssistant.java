package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.editing.Completion;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextRange;
import dev.eventchain.ocl.editing.Member;
import dev.eventchain.ocl.editing.Members;
import dev.eventchain.ocl.editing.Mention;
import dev.eventchain.ocl.editing.Mentions;
import dev.eventchain.ocl.text.Lexer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.utilities.ASTNode;

/** Assistant for the expressions of a language, complete or half-typed. */
public final class ExpressionAssistant {

  private final ExpressionLanguage language;

  ExpressionAssistant(ExpressionLanguage language) {
    this.language = language;
  }

  /**
   * Returns what the names in an expression mean, in the order of the text. Names that are not
   * understood are left out; of an expression that cannot be parsed, these are all.
   */
  public List<Mention> mentions(SourceRange range, Scope scope) {
    if (range.text().isBlank()) {
      return List.of();
    }
    return language
        .understand(range, scope)
        .map(tree -> Mentions.in(tree, range.source().text()))
        .orElse(List.of())
        .stream()
        .filter(each -> range.start() <= each.start() && each.end() <= range.end())
        .map(each -> located(each, scope))
        .toList();
  }

  /** Returns what the name at an offset means, also in an expression that cannot be parsed. */
  public Optional<Mention> mention(SourceRange range, Scope scope, int offset) {
    return touching(mentions(range, scope), offset)
        .or(() -> inOpenExpression(range, scope, offset));
  }

  private Optional<Mention> inOpenExpression(SourceRange range, Scope scope, int offset) {
    int end = endOfWord(range, offset);
    if (end == startOfWord(range, offset) || isSilent(range, offset)) {
      return Optional.empty();
    }
    String text = range.source().text();
    OpenExpression open = open(range, scope, end);
    int next = end;
    while (next < range.end() && Character.isWhitespace(text.charAt(next))) {
      next++;
    }
    int close = next < range.end() && text.charAt(next) == '(' ? closing(range, next) : -1;
    SourceRange chain = open.chain().orElse(range);
    SourceRange whole = range.source().range(chain.start(), close < 0 ? end : close + 1);
    List<Scope> scopes = new ArrayList<>();
    open.implicit().forEach(type -> scopes.add(open.scope().with("self", type)));
    scopes.add(open.scope());
    return scopes.stream()
        .flatMap(where -> touching(mentions(whole, where), offset).stream())
        .findFirst();
  }

  private static int closing(SourceRange range, int open) {
    int depth = 0;
    String text = range.source().text();
    for (int i = open; i < range.end(); i = Lexer.end(text, i, range.end())) {
      depth += text.charAt(i) == '(' ? 1 : text.charAt(i) == ')' ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    return -1;
  }

  private static Optional<Mention> touching(List<Mention> mentions, int offset) {
    return mentions.stream().filter(each -> each.touches(offset)).findFirst();
  }

  private static Mention located(Mention mention, Scope scope) {
    return mention.kind() == Mention.Kind.VARIABLE && mention.declaredAt() == Mention.ELSEWHERE
        ? mention.declaredAt(scope.offsetOf(mention.name()))
        : mention;
  }

  /** Returns the proposals at an offset, the most suitable first. */
  public List<Completion> completions(SourceRange range, Scope scope, int offset, TextLines lines) {
    if (isSilent(range, offset)) {
      return List.of();
    }
    int start = startOfWord(range, offset);
    int end = endOfWord(range, offset);
    OpenExpression open = open(range, scope, start);
    ExpressionProposals proposals =
        new ExpressionProposals(language, open, lines.range(start, end), isCalled(range, end));
    synchronized (language) { // Types are looked up where the parser adds others.
      return proposals.all();
    }
  }

  /** Returns the types that can be named at an offset, after {@code package::} only those in it. */
  public List<Completion> types(SourceRange range, int offset, TextLines lines) {
    int start = startOfWord(range, offset);
    OpenExpression open = open(range, Scope.EMPTY, start);
    TextRange replaced = lines.range(start, endOfWord(range, offset));
    return new ExpressionProposals(language, open, replaced, true).types();
  }

  /** Returns whether a class, one above it or one below it has a feature or operation of a name. */
  public boolean hasMember(EClassifier owner, String name) {
    List<EClassifier> classes = new ArrayList<>(List.of(owner));
    if (owner instanceof EClass type) {
      classes.addAll(language.packages().classesBelow(type));
    }
    synchronized (language) {
      return classes.stream()
          .flatMap(each -> Members.afterDot(language.environment(), each).stream())
          .anyMatch(each -> each.name().equals(name));
    }
  }

  /** Returns the type of a feature, an operation or a parameter. */
  public EClassifier typeOf(ETypedElement element) {
    synchronized (language) {
      return language.typeOf(element);
    }
  }

  /** Returns the signatures of the call whose parentheses are around an offset. */
  public Optional<SignatureHelp> signatureHelp(SourceRange range, Scope scope, int offset) {
    if (isSilent(range, offset)) {
      return Optional.empty();
    }
    OpenExpression open = open(range, scope, offset);
    synchronized (language) {
      return open.call().flatMap(call -> help(call, open));
    }
  }

  private Optional<SignatureHelp> help(OpenExpression.Call call, OpenExpression open) {
    List<Member> candidates = new ArrayList<>();
    if (call.operator().isEmpty()) {
      candidates.addAll(Members.functions(language.environment()));
      implicitSources(open)
          .forEach(type -> candidates.addAll(Members.afterDot(language.environment(), type)));
    } else {
      call.source()
          .ifPresent(
              type ->
                  candidates.addAll(
                      call.operator().equals("->")
                          ? Members.afterArrow(language.environment(), type)
                          : Members.afterDot(language.environment(), type)));
    }
    List<SignatureHelp.Signature> signatures =
        candidates.stream()
            .filter(each -> each.name().equals(call.name()) && each.parameters() != null)
            .sorted(
                java.util.Comparator.comparing(each -> each.parameters().size() <= call.argument()))
            .map(ExpressionProposals::signature)
            .distinct()
            .toList();
    return signatures.isEmpty()
        ? Optional.empty()
        : Optional.of(new SignatureHelp(signatures, call.argument()));
  }

  /** Returns the types whose members can be named without a source, the innermost first. */
  static List<EClassifier> implicitSources(OpenExpression open) {
    List<EClassifier> sources = new ArrayList<>(open.implicit());
    EClassifier self = open.scope().typeOf("self");
    if (self != null) {
      sources.add(self);
    }
    return sources;
  }

  /** Returns the variables that an expression declares without their types, with these types. */
  public List<Mention> untypedVariables(SourceRange range, Scope scope) {
    String text = range.source().text();
    return mentions(range, scope).stream()
        .filter(each -> each.kind() == Mention.Kind.DECLARATION && each.type() != null)
        .filter(each -> !text.substring(each.end(), range.end()).stripLeading().startsWith(":"))
        .toList();
  }

  /** Returns the parts of an expression around an offset, the innermost first. */
  public List<SourceRange> partsAround(SourceRange range, Scope scope, int offset) {
    List<SourceRange> parts = new ArrayList<>();
    language
        .understand(range, scope)
        .ifPresent(
            tree -> {
              addPart(tree, range, offset, parts);
              EcoreUtil.<EObject>getAllContents(List.of(tree))
                  .forEachRemaining(
                      each -> {
                        if (each instanceof ASTNode node) {
                          addPart(node, range, offset, parts);
                        }
                      });
            });
    parts.sort(java.util.Comparator.comparingInt(each -> each.end() - each.start()));
    return parts.stream().distinct().toList();
  }

  private static void addPart(
      ASTNode node, SourceRange range, int offset, List<SourceRange> parts) {
    int start = Math.max(node.getStartPosition(), range.start());
    int end = Math.min(node.getEndPosition(), range.end());
    if (start <= offset && offset <= end && start < end) {
      parts.add(range.source().range(start, end));
    }
  }

  private OpenExpression open(SourceRange range, Scope scope, int end) {
    return new OpenExpression(language, range.source().range(range.start(), end), scope);
  }

  /** Returns whether an opening parenthesis follows. */
  private static boolean isCalled(SourceRange range, int end) {
    return range.source().text().startsWith("(", end);
  }

  private static int startOfWord(SourceRange range, int offset) {
    int start = offset;
    String text = range.source().text();
    while (start > range.start() && Character.isJavaIdentifierPart(text.charAt(start - 1))) {
      start--;
    }
    return start;
  }

  private static int endOfWord(SourceRange range, int offset) {
    int end = offset;
    String text = range.source().text();
    while (end < range.end() && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return end;
  }

  /** Returns whether an offset is in a string, a comment or a number. */
  private static boolean isSilent(SourceRange range, int offset) {
    String text = range.source().text();
    for (int i = range.start(); i < offset; ) {
      int end = Lexer.end(text, i, range.end());
      char c = text.charAt(i);
      boolean line = text.startsWith("--", i);
      boolean string = c == '\'' || c == '"';
      boolean apart = line || string || text.startsWith("/*", i);
      boolean open = line || (string && !isClosed(text, i, end));
      if (offset < end || (offset == end && (open || Character.isDigit(c)))) {
        return apart || Character.isDigit(c);
      }
      i = end;
    }
    return false;
  }

  private static boolean isClosed(String text, int start, int end) {
    return end - start > 1 && text.charAt(end - 1) == text.charAt(start);
  }
}
