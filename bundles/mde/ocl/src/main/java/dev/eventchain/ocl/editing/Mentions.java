package dev.eventchain.ocl.editing;

import dev.eventchain.ocl.editing.Mention.Kind;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.parse.Libraries;
import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.tree.Asts;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.ecore.TypeType;
import org.eclipse.ocl.expressions.EnumLiteralExp;
import org.eclipse.ocl.expressions.LoopExp;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.expressions.PropertyCallExp;
import org.eclipse.ocl.expressions.TypeExp;
import org.eclipse.ocl.expressions.Variable;
import org.eclipse.ocl.expressions.VariableExp;
import org.eclipse.ocl.types.CollectionType;
import org.eclipse.ocl.utilities.CallingASTNode;

/**
 * Finds the names in a syntax tree. Nodes that are not written, such as an implicit {@code self},
 * have places, too, but another text stands there.
 */
public final class Mentions {

  private final String text;
  private final List<Mention> found = new ArrayList<>();

  private Mentions(String text) {
    this.text = text;
  }

  /** Returns the names in a tree, in the order of the text whose offsets the tree has. */
  public static List<Mention> in(OCLExpression<EClassifier> tree, String text) {
    Mentions mentions = new Mentions(text);
    Iterator<EObject> all = EcoreUtil.getAllContents(List.of(tree));
    while (all.hasNext()) {
      mentions.add(all.next());
    }
    mentions.found.sort(Comparator.comparingInt(Mention::start).thenComparing(Mention::end));
    return mentions.found.stream().distinct().toList();
  }

  private void add(EObject node) {
    if (node instanceof PropertyCallExp<?, ?> read) {
      addCall(read, Kind.FEATURE, read.getReferredProperty(), typeOf(read.getSource()));
    } else if (node instanceof OperationCallExp<?, ?> call) {
      Object operation = call.getReferredOperation();
      if (operation instanceof Libraries.LibraryOperation library) {
        addNamed(call, Kind.LIBRARY_OPERATION, library.getName(), library.implementation(), call);
      } else {
        addCall(call, Kind.OPERATION, operation, typeOf(call.getSource()));
      }
    } else if (node instanceof LoopExp<?, ?> loop) {
      addNamed(loop, Kind.ITERATOR, loop.getName(), null, loop);
    } else if (node instanceof Variable<?, ?> variable) {
      addDeclaration(variable);
    } else if (node instanceof VariableExp<?, ?> use) {
      addUse(use);
    } else if (node instanceof TypeExp<?> type) {
      addType(type.getStartPosition(), type.getEndPosition(), (EClassifier) type.getReferredType());
    } else if (node instanceof EnumLiteralExp<?, ?> literal) {
      addLiteral(literal);
    }
  }

  private void addCall(CallingASTNode call, Kind kind, Object target, EClassifier owner) {
    if (target != null && !Keywords.ALL.contains(Names.of(target))) {
      EClassifier type = (EClassifier) ((OCLExpression<?>) call).getType();
      int start = call.getPropertyStartPosition();
      addAt(start, kind, Names.of(target), target, type, owner, Mention.ELSEWHERE);
    }
  }

  private void addNamed(
      CallingASTNode call, Kind kind, String name, Object target, OCLExpression<?> node) {
    OCLExpression<?> source =
        call instanceof org.eclipse.ocl.expressions.CallExp<?> each ? each.getSource() : null;
    int start = call.getPropertyStartPosition();
    if (!isNamed(name, start) && source != null) {
      start = firstName(name, source.getEndPosition(), node.getEndPosition());
    }
    addAt(
        start, kind, name, target, (EClassifier) node.getType(), typeOf(source), Mention.ELSEWHERE);
  }

  @SuppressWarnings("unchecked")
  private static EClassifier typeOf(OCLExpression<?> source) {
    return source == null
        ? null
        : Asts.withoutImplicitSet((OCLExpression<EClassifier>) source).getType();
  }

  private void addDeclaration(Variable<?, ?> variable) {
    int start = variable.getStartPosition();
    EClassifier type = (EClassifier) variable.getType();
    addAt(start, Kind.DECLARATION, variable.getName(), null, type, null, start);
    if (variable.getTypeStartPosition() > start) {
      addType(variable.getTypeStartPosition(), variable.getTypeEndPosition(), type);
    }
  }

  private void addUse(VariableExp<?, ?> use) {
    Variable<?, ?> variable = use.getReferredVariable();
    if (variable != null) {
      boolean inside = isNamed(variable.getName(), variable.getStartPosition());
      addAt(
          use.getStartPosition(),
          Kind.VARIABLE,
          variable.getName(),
          null,
          (EClassifier) variable.getType(),
          null,
          inside ? variable.getStartPosition() : Mention.ELSEWHERE);
    }
  }

  /** Adds the last name of a qualified one, also inside the type of a collection. */
  private void addType(int start, int end, EClassifier type) {
    EClassifier named = type instanceof TypeType literal ? literal.getReferredType() : type;
    while (named instanceof CollectionType<?, ?> collection) {
      named = (EClassifier) collection.getElementType();
    }
    int at = named == null || named.getName() == null ? -1 : lastName(named.getName(), start, end);
    if (at >= 0) {
      addAt(at, Kind.TYPE, named.getName(), named, named, null, Mention.ELSEWHERE);
    }
  }

  private void addLiteral(EnumLiteralExp<?, ?> node) {
    Object target = node.getReferredEnumLiteral();
    if (target instanceof EEnumLiteral literal && literal.getEEnum() != null) {
      EClassifier owner = literal.getEEnum();
      int at = lastName(literal.getName(), node.getStartPosition(), node.getEndPosition());
      addAt(at, Kind.LITERAL, literal.getName(), literal, owner, owner, Mention.ELSEWHERE);
      addType(node.getStartPosition(), Math.max(node.getStartPosition(), at), owner);
    }
  }

  /** Returns the offset of the first occurrence of a name in a range; -1 if there is none. */
  private int firstName(String name, int start, int end) {
    for (int at = Math.max(start, 0); at < Math.min(end, text.length()); at++) {
      if (isNamed(name, at)) {
        return at;
      }
    }
    return -1;
  }

  /** Returns the offset of the last occurrence of a name in a range; -1 if there is none. */
  private int lastName(String name, int start, int end) {
    int limit = Math.min(end, text.length());
    for (int at = limit - name.length(); at >= Math.max(start, 0); at--) {
      if (isNamed(name, at)) {
        return at;
      }
    }
    return -1;
  }

  private void addAt(
      int start,
      Kind kind,
      String name,
      Object target,
      EClassifier type,
      EClassifier owner,
      int declaredAt) {
    int escape = start >= 0 && text.startsWith("_", start) && !isNamed(name, start) ? 1 : 0;
    int at = start + escape;
    if (isNamed(name, at)) {
      int end = at + name.length();
      found.add(new Mention(at, end, kind, name, target, type, owner, declaredAt));
    }
  }

  /** Returns whether a whole word at an offset is this name. */
  private boolean isNamed(String name, int at) {
    return at >= 0
        && name != null
        && !name.isEmpty()
        && Character.isJavaIdentifierStart(name.charAt(0))
        && text.startsWith(name, at)
        && !isPart(at + name.length())
        && !(isPart(at - 1) && (text.charAt(at - 1) != '_' || isPart(at - 2)));
  }

  private boolean isPart(int at) {
    return at >= 0 && at < text.length() && Character.isJavaIdentifierPart(text.charAt(at));
  }
}
