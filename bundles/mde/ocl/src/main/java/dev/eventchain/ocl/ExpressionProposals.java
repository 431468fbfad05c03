package dev.eventchain.ocl;

import dev.eventchain.editing.Completion;
import dev.eventchain.editing.ElementKind;
import dev.eventchain.editing.SignatureHelp;
import dev.eventchain.editing.TextRange;
import dev.eventchain.ocl.editing.Descriptions;
import dev.eventchain.ocl.editing.Member;
import dev.eventchain.ocl.editing.Members;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.text.Keywords;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;
import org.eclipse.emf.ecore.EPackage;

/** The proposals at one place of an expression. */
final class ExpressionProposals {

  /** Words after a complete operand. */
  private static final List<String> CONNECTIVES =
      List.of("and", "or", "implies", "xor", "then", "else", "endif", "in", "div", "mod");

  /** Words that begin an operand. */
  private static final List<String> OPERANDS =
      List.of("not", "true", "false", "null", "if", "let", "invalid");

  /** Words after which an operand is expected. */
  private static final Set<String> BEFORE_OPERANDS =
      Set.of("and", "or", "implies", "xor", "then", "else", "in", "div", "mod", "not", "if", "let");

  private static final Set<String> OF_TYPES =
      Set.of(
          "oclIsKindOf",
          "oclIsTypeOf",
          "oclAsType",
          "selectByKind",
          "selectByType",
          "filter",
          "eAllContents",
          "eContainer",
          "eInverse",
          "ancestors",
          "siblings",
          "precedingSiblings",
          "followingSiblings",
          "eContents",
          "descendants");

  private record Snippet(String label, String text) {}

  private static final List<Snippet> SNIPPETS =
      List.of(
          new Snippet(
              "if ... then ... else ... endif",
              "if ${1:condition} then ${2:value} else ${3:other} endif"),
          new Snippet("let ... in ...", "let ${1:name} = ${2:value} in $0"));

  private final ExpressionLanguage language;
  private final OpenExpression open;
  private final TextRange replaced;
  private final boolean called;
  private final Map<String, Completion> found = new LinkedHashMap<>();

  /**
   * The proposals at the end of an open expression.
   *
   * @param replaced the word that they replace
   * @param called true if a parenthesis follows
   */
  ExpressionProposals(
      ExpressionLanguage language, OpenExpression open, TextRange replaced, boolean called) {
    this.language = language;
    this.open = open;
    this.replaced = replaced;
    this.called = called;
  }

  List<Completion> all() {
    switch (open.last()) {
      case "." -> addMembers(false);
      case "->" -> addMembers(true);
      case "::" -> addInside(open.path());
      case "@" -> add("pre", ElementKind.KEYWORD, "", "", "pre");
      case "^", "'" -> {}
      case ":" -> addTypes();
      default -> addHere();
    }
    return List.copyOf(found.values());
  }

  /** Returns the types alone. */
  List<Completion> types() {
    if (open.last().equals("::")) {
      addInside(open.path());
    } else {
      addTypes();
    }
    return List.copyOf(found.values());
  }

  private void addMembers(boolean arrow) {
    open.receiverType()
        .ifPresent(
            type -> {
              List<Member> members =
                  arrow
                      ? Members.afterArrow(language.environment(), type)
                      : Members.afterDot(language.environment(), type);
              members.forEach(this::add);
            });
  }

  private void addHere() {
    String last = open.last();
    if (isOperand(last)) {
      CONNECTIVES.forEach(word -> add(word, ElementKind.KEYWORD, "", "", word));
      return;
    } else if (last.equals("let")) {
      return;
    }
    boolean type = last.equals("(") && OF_TYPES.contains(open.beforeLast());
    if (type) {
      addTypes();
    }
    for (String name : open.scope().names()) {
      String of = Members.name(open.scope().typeOf(name));
      add(name, ElementKind.VARIABLE, of, "", name);
    }
    for (EClassifier source : ExpressionAssistant.implicitSources(open)) {
      Members.afterDot(language.environment(), source).forEach(this::add);
    }
    Members.functions(language.environment()).forEach(this::add);
    if (!type) {
      addTypes();
    }
    OPERANDS.forEach(word -> add(word, ElementKind.KEYWORD, "", "", word));
    for (Snippet each : SNIPPETS) {
      found.put(
          each.label(),
          new Completion(each.label(), ElementKind.SNIPPET, "", "", each.text(), true, replaced));
    }
  }

  /** Returns whether an operand ends with a token, so that a connective can follow. */
  private static boolean isOperand(String last) {
    return !last.isEmpty()
        && (Character.isJavaIdentifierPart(last.charAt(last.length() - 1))
            || ")}]'\"".indexOf(last.charAt(last.length() - 1)) >= 0)
        && !BEFORE_OPERANDS.contains(last);
  }

  private void addTypes() {
    for (EPackage each : language.packages().all()) {
      each.getEClassifiers().forEach(this::add);
    }
    for (String type : Keywords.TYPES) {
      add(type, ElementKind.STANDARD_TYPE, "", "", type);
    }
    for (EPackage each : language.packages().all()) {
      if (each.getESuperPackage() == null) {
        add(each.getName(), ElementKind.PACKAGE, String.valueOf(each.getNsURI()), "", "");
      }
    }
  }

  /** Adds what is in a package or an enumeration. */
  private void addInside(List<String> path) {
    PackageIndex packages = language.packages();
    for (EPackage each : packages.packages(path)) {
      each.getEClassifiers().forEach(this::add);
      each.getESubpackages()
          .forEach(
              nested -> add(nested.getName(), ElementKind.PACKAGE, "" + nested.getNsURI(), "", ""));
    }
    for (EClassifier each : packages.classifiers(path)) {
      if (each instanceof EEnum enumeration) {
        enumeration
            .getELiterals()
            .forEach(
                literal ->
                    add(
                        literal.getName(),
                        ElementKind.ENUMERATION_LITERAL,
                        Members.name(each),
                        Descriptions.documentation(literal),
                        ""));
      }
    }
  }

  private void add(EClassifier type) {
    if (type.getName() != null) {
      ElementKind kind =
          type instanceof EClass
              ? ElementKind.CLASS
              : type instanceof EEnum ? ElementKind.ENUMERATION : ElementKind.DATA_TYPE;
      String detail = type.getEPackage() == null ? "" : type.getEPackage().getName();
      add(type.getName(), kind, detail, Descriptions.documentation(type), "");
    }
  }

  private void add(Member member) {
    boolean call = member.parameters() != null;
    boolean written = call && !called;
    String text = written ? insertText(member) : member.name();
    String key = member.name() + (call ? member.parameters() : "");
    found.putIfAbsent(
        key,
        new Completion(
            member.name(),
            member.kind(),
            member.signature().substring(member.name().length()).strip()
                + (member.origin().isEmpty() ? "" : " – " + member.origin()),
            Descriptions.documentation(member.element()),
            text,
            written && !member.parameters().isEmpty(),
            replaced));
  }

  private void add(
      String label, ElementKind kind, String detail, String documentation, String text) {
    String inserted = text.isEmpty() ? label : text;
    found.putIfAbsent(
        label, new Completion(label, kind, detail, documentation, inserted, false, replaced));
  }

  private static String insertText(Member member) {
    if (member.kind() == ElementKind.ITERATOR) {
      return member.name().equals("iterate")
          ? "iterate(${1:each}; ${2:result} : ${3:Type} = ${4:initial} | $0)"
          : member.name() + "(${1:each} | $0)";
    }
    List<String> places = new ArrayList<>();
    for (String parameter : member.parameters()) {
      String name = parameter.replaceFirst(" : .*", "").replaceAll("[$}\\\\]", "\\\\$0");
      places.add("${" + (places.size() + 1) + ":" + name + "}");
    }
    return member.name() + "(" + String.join(", ", places) + ")";
  }

  /** Returns the signature of an operation, for a list of signatures. */
  static SignatureHelp.Signature signature(Member member) {
    return new SignatureHelp.Signature(
        member.signature(), Descriptions.documentation(member.element()), member.parameters());
  }
}
