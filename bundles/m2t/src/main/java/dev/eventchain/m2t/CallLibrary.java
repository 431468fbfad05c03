package dev.eventchain.m2t;

import dev.eventchain.ocl.Evaluation;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Invalid;
import dev.eventchain.ocl.OperationLibrary;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/**
 * The templates and queries that a module can call, as operations: {@code x.name(y)} and {@code
 * name(x, y)} are the same call. Which one is meant is decided at run time by the arguments: the
 * one with the most special parameters that takes them.
 */
final class CallLibrary implements OperationLibrary {
  private final List<Callable> visible = new ArrayList<>();
  private ExpressionLanguage language;

  /** Says over which types the calls are; a library is made before its language is. */
  void use(ExpressionLanguage newLanguage) {
    language = newLanguage;
  }

  /** Makes a callable visible; of two with the same parameters the first added wins. */
  void add(Callable callable) {
    if (!visible.contains(callable)) {
      visible.add(callable);
    }
  }

  /** The templates of a name, in the order in which they became visible. */
  List<Template> templates(String name) {
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
  public Optional<Operation> lookup(
      EClassifier source, String name, List<EClassifier> argumentTypes) {
    List<EClassifier> types = new ArrayList<>(argumentTypes);
    if (source != null) {
      types.add(0, source);
    }
    List<Callable> candidates =
        visible.stream()
            .filter(callable -> callable.name().equals(name))
            .filter(callable -> callable.parameters().size() == types.size())
            .toList();
    Optional<Callable> found =
        candidates.stream().filter(callable -> conform(types, callable)).findFirst();
    return found.map(
        callable ->
            new Operation(
                name,
                callable.resultType(),
                new Call(name, bySpeciality(candidates), source != null)));
  }

  private boolean conform(List<EClassifier> types, Callable callable) {
    for (int i = 0; i < types.size(); i++) {
      if (!language.conforms(types.get(i), callable.parameters().get(i).type())) {
        return false;
      }
    }
    return true;
  }

  /**
   * Each callable comes after those that are more special, and after its likes that have a guard;
   * otherwise the order stays.
   */
  private List<Callable> bySpeciality(List<Callable> candidates) {
    List<Callable> rest = new ArrayList<>(candidates);
    rest.sort(Comparator.comparing(callable -> !callable.hasGuard()));
    List<Callable> sorted = new ArrayList<>();
    while (!rest.isEmpty()) {
      Callable next =
          rest.stream()
              .filter(each -> rest.stream().noneMatch(other -> isMoreSpecial(other, each)))
              .findFirst()
              .orElse(rest.get(0));
      sorted.add(next);
      rest.remove(next);
    }
    return List.copyOf(sorted);
  }

  private boolean isMoreSpecial(Callable one, Callable other) {
    return one != other
        && conform(one.parameters().stream().map(Callable.Parameter::type).toList(), other)
        && !conform(other.parameters().stream().map(Callable.Parameter::type).toList(), one);
  }

  /** A call of one of some callables, the most special first. */
  static final class Call implements OperationLibrary.Implementation {
    private final String name;
    private final boolean hasSource;
    private final Callable[] candidates;

    private Call(String name, List<Callable> candidates, boolean hasSource) {
      this.name = name;
      this.candidates = candidates.toArray(Callable[]::new);
      this.hasSource = hasSource;
    }

    List<Callable> candidates() {
      return List.of(candidates);
    }

    boolean callsTemplates() {
      return candidates[0] instanceof Template;
    }

    @Override
    public Object call(Object source, List<Object> arguments, Evaluation evaluation) {
      GenerationRun run = evaluation.attachment(GenerationRun.class);
      List<Object> all = all(source, arguments);
      Callable callable = find(all, run);
      if (callable != null) {
        return callable.call(all, run);
      }
      return callsTemplates()
          ? ""
          : new Invalid("no query '" + name + "' takes these arguments", run.place(), false);
    }

    /**
     * Writes the text of the call, or the value if it is a query that takes the arguments.
     *
     * @param indentation what goes behind each of its line breaks
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

    /** Null suits every type; it means the most general candidate that expects anything. */
    private Callable find(List<Object> arguments, GenerationRun run) {
      boolean fromTheMostGeneral = !arguments.isEmpty() && arguments.get(0) == null;
      for (int i = 0; i < candidates.length; i++) {
        Callable candidate = candidates[fromTheMostGeneral ? candidates.length - 1 - i : i];
        if (candidate.accepts(arguments, run)) {
          return candidate;
        }
      }
      return null;
    }
  }
}
