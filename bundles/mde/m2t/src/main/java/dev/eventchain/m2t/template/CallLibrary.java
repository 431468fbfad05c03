package dev.eventchain.m2t.template;

import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.text.Texts;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Library of the templates and queries that a module can call. The calls {@code x.name(y)} and
 * {@code name(x, y)} are equivalent. Templates are dispatched at run time to the one with the most
 * specific parameters that accepts the arguments. Queries are dispatched by the static types of the
 * arguments, or at run time if a query accepts only some values of these types.
 */
public final class CallLibrary implements OperationLibrary {
  private final List<Callable> visible = new ArrayList<>();

  /** Makes a callable visible; of two with equal parameters, the first one wins. */
  public void add(Callable callable) {
    if (!visible.contains(callable)) {
      visible.add(callable);
    }
  }

  /** Returns the templates of a name, in the order in which they became visible. */
  public List<Template> templates(String name) {
    return visible.stream()
        .filter(Template.class::isInstance)
        .map(Template.class::cast)
        .filter(template -> template.name().equals(name))
        .toList();
  }

  @Override
  public Collection<String> names() {
    return visible.stream().map(Callable::name).distinct().toList();
  }

  @Override
  public List<Signature> signatures(TypeSystem language, EClassifier source) {
    Signatures types = new Signatures(language);
    return visible.stream()
        .filter(each -> source == null || takes(each, source, types))
        .map(each -> signature(each, source == null ? 0 : 1))
        .toList();
  }

  private static boolean takes(Callable callable, EClassifier source, Signatures types) {
    return !callable.parameters().isEmpty()
        && types.mayFit(source, callable.parameters().get(0).type());
  }

  private static Signature signature(Callable callable, int from) {
    List<String> parameters =
        callable.parameters().subList(from, callable.parameters().size()).stream()
            .map(each -> each.name() + " : " + each.type().getName())
            .toList();
    return new Signature(
        callable.name(),
        parameters,
        callable.resultType().getName(),
        callable instanceof Query ? "query" : "template");
  }

  @Override
  public Optional<Operation> lookup(
      TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
    return operation(language, source, name, argumentTypes, false);
  }

  @Override
  public Optional<Operation> lookupLoosely(
      TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
    return operation(language, source, name, argumentTypes, true);
  }

  private Optional<Operation> operation(
      TypeSystem language,
      EClassifier source,
      String name,
      List<EClassifier> argumentTypes,
      boolean loosely) {
    if (source == null) {
      return operation(language, name, argumentTypes, loosely, false);
    }
    List<EClassifier> types = new ArrayList<>(argumentTypes);
    types.add(0, source);
    // As in Acceleo, x.name(x, y) is the same as x.name(y): the source has no influence then.
    return operation(language, name, types, loosely, true)
        .or(() -> operation(language, name, argumentTypes, loosely, false));
  }

  private Optional<Operation> operation(
      TypeSystem language,
      String name,
      List<EClassifier> types,
      boolean loosely,
      boolean hasSource) {
    Signatures signatures = new Signatures(language);
    List<Callable> candidates =
        visible.stream()
            .filter(callable -> callable.name().equals(name))
            .filter(callable -> callable.parameters().size() == types.size())
            .toList();
    List<Callable> suitable = signatures.suiting(types, candidates, loosely);
    if (suitable.isEmpty()) {
      return Optional.empty();
    }
    Callable meant = suitable.get(0);
    List<Callable> called = called(meant, candidates, signatures, loosely);
    boolean one = called.stream().allMatch(each -> each.resultType().equals(meant.resultType()));
    List<Callable> general = fromTheMostGeneral(called);
    Call call = new Call(name, overridingFirst(called), overridingFirst(general), hasSource);
    return Optional.of(new Operation(name, one ? meant.resultType() : language.any(), call));
  }

  /**
   * Returns the callables with the most specific last; those with equal parameters keep their
   * order.
   */
  private static List<Callable> fromTheMostGeneral(List<Callable> callables) {
    List<Callable> general = new ArrayList<>();
    for (Callable callable : callables) {
      int alike = general.stream().map(CallLibrary::types).toList().lastIndexOf(types(callable));
      general.add(alike + 1, callable);
    }
    return general;
  }

  private static List<EClassifier> types(Callable callable) {
    return callable.parameters().stream().map(Callable.Parameter::type).toList();
  }

  /** Returns the candidates of a call at run time, most specific first. */
  private static List<Callable> called(
      Callable meant, List<Callable> candidates, Signatures signatures, boolean loosely) {
    if (loosely) {
      return signatures.bySpeciality(candidates);
    }
    return meant instanceof Query
        ? List.of(meant)
        : signatures.bySpeciality(candidates.stream().filter(Template.class::isInstance).toList());
  }

  /**
   * Places each template after those that override it, as their fallback if guards refuse. Only
   * templates visible to the module count, so overriding in other modules does not affect its
   * calls.
   */
  private List<Callable> overridingFirst(List<Callable> callables) {
    Set<Callable> ordered = new LinkedHashSet<>();
    callables.forEach(callable -> addOverridingFirst(callable, ordered));
    return List.copyOf(ordered);
  }

  private void addOverridingFirst(Callable callable, Set<Callable> into) {
    for (Callable other : visible) {
      if (other instanceof Template template && template.overridden().contains(callable)) {
        addOverridingFirst(other, into);
      }
    }
    into.add(callable);
  }

  /** Call that is dispatched to one of several callables. */
  public static final class Call implements OperationLibrary.Implementation {
    private final String name;
    private final boolean hasSource;
    private final Callable[] candidates;
    private final Callable[] fromTheMostGeneral;

    /** Computed on first use, when all modules are complete. */
    private volatile Boolean repeatable;

    /**
     * Creates a call.
     *
     * @param candidates the candidates, most specific first
     * @param fromTheMostGeneral the candidates for null, most general first
     */
    private Call(
        String name,
        List<Callable> candidates,
        List<Callable> fromTheMostGeneral,
        boolean hasSource) {
      this.name = name;
      this.candidates = candidates.toArray(Callable[]::new);
      this.fromTheMostGeneral = fromTheMostGeneral.toArray(Callable[]::new);
      this.hasSource = hasSource;
    }

    public List<Callable> candidates() {
      return List.of(candidates);
    }

    public boolean callsTemplates() {
      return candidates[0] instanceof Template;
    }

    /**
     * Returns true for queries, whose results are only checked against their declared types at run
     * time.
     */
    @Override
    public boolean mayGiveOtherTypes() {
      return !callsTemplates();
    }

    /** Returns true for queries, as in Acceleo; but what a Java service gives is a list of Java. */
    @Override
    public boolean keepsKinds() {
      return candidates[0] instanceof Query query && !query.isService();
    }

    /**
     * Returns true for queries that call only repeatable operations. Templates may write files, and
     * recursive queries may not terminate for some elements.
     */
    @Override
    public boolean isRepeatable() {
      Boolean known = repeatable;
      if (known == null) {
        repeatable = false;
        known = Stream.of(candidates).allMatch(Call::callsRepeatableOnly);
        repeatable = known;
      }
      return known;
    }

    private static boolean callsRepeatableOnly(Callable callable) {
      return callable instanceof Query query
          && query.calls().allMatch(OperationLibrary.Implementation::isRepeatable);
    }

    @Override
    public Object call(Object source, List<Object> arguments, Evaluation evaluation) {
      GenerationRun run = evaluation.attachment(GenerationRun.class);
      List<Object> all = all(source, arguments);
      Callable callable = find(all, run);
      return callable == null ? untaken(all, run) : callable.call(all, run);
    }

    /**
     * Returns empty text if guards refuse; an {@code Invalid} if no parameters accept the
     * arguments.
     */
    private Object untaken(List<Object> arguments, GenerationRun run) {
      if (Stream.of(candidates).anyMatch(candidate -> candidate.takes(arguments))) {
        return "";
      }
      return new Invalid(
          "no %s '%s' takes these arguments"
              .formatted(callsTemplates() ? "template" : "query", name),
          run.place(),
          Invalid.Kind.OTHER);
    }

    /**
     * Writes the text of the called template, or the value of the called query.
     *
     * @param indentation the text inserted after each of its line breaks
     * @return an {@link Invalid} if there is no value; otherwise null
     */
    Object write(Object source, List<Object> arguments, GenerationRun run, String indentation) {
      List<Object> all = all(source, arguments);
      Callable callable = find(all, run);
      if (callable instanceof Template template) {
        template.write(all, run, indentation);
      } else if (callable != null) {
        Object value = callable.call(all, run);
        if (value instanceof Invalid) {
          return value;
        }
        run.appendIndented(Texts.of(value), indentation);
      } else if (untaken(all, run) instanceof Invalid invalid) {
        return invalid;
      }
      return null;
    }

    private List<Object> all(Object source, List<Object> arguments) {
      if (!hasSource) {
        return arguments;
      }
      Object[] all = new Object[arguments.size() + 1];
      all[0] = source;
      for (int i = 1; i < all.length; i++) {
        all[i] = arguments.get(i - 1);
      }
      return Arrays.asList(all);
    }

    /**
     * Returns the first candidate that accepts the arguments. Null fits every type, so for null the
     * most general candidate comes first.
     */
    private Callable find(List<Object> arguments, GenerationRun run) {
      boolean isNull = !arguments.isEmpty() && arguments.get(0) == null;
      for (Callable candidate : isNull ? fromTheMostGeneral : candidates) {
        if (candidate.accepts(arguments, run)) {
          return candidate;
        }
      }
      return null;
    }
  }
}
