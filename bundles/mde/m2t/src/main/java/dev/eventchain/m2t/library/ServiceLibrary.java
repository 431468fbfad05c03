package dev.eventchain.m2t.library;

import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.services.ServiceException;
import dev.eventchain.m2t.services.Services;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** {@code invoke('class', 'method(types)', Sequence{arguments})}: calls of Java services. */
public final class ServiceLibrary implements OperationLibrary {
  private static final String NAME = "invoke";

  private final Services services;

  public ServiceLibrary(Services services) {
    this.services = services;
  }

  @Override
  public Collection<String> names() {
    return List.of(NAME);
  }

  @Override
  public Optional<Operation> lookup(
      TypeSystem language, EClassifier source, String name, List<EClassifier> argumentTypes) {
    boolean suits =
        name.equals(NAME)
            && argumentTypes.size() == 3
            && isText(argumentTypes.get(0), language)
            && isText(argumentTypes.get(1), language)
            && isCollection(argumentTypes.get(2), language);
    return suits
        ? Optional.of(new Operation(NAME, language.any(), new Call(services)))
        : Optional.empty();
  }

  /** Returns whether a type is one of collections, or that of null. */
  private static boolean isCollection(EClassifier type, TypeSystem language) {
    return language.elementType(type).isPresent()
        || language.conforms(type, language.sequenceOf(language.any()));
  }

  private static boolean isText(EClassifier type, TypeSystem language) {
    return language.elementType(type).isEmpty() && language.conforms(type, language.type("String"));
  }

  /** Call of a service, whose result type is only known at run time. */
  public record Call(Services services) implements OperationLibrary.Implementation {
    @Override
    public Object call(Object source, List<Object> arguments, Evaluation run) {
      if (arguments.get(0) == null || arguments.get(1) == null) {
        throw new ServiceException("the Java service is named by null");
      }
      return services.call(
          (String) arguments.get(0),
          (String) arguments.get(1),
          (Collection<?>) arguments.get(2),
          run.attachment(GenerationRun.class).serviceInstances());
    }
  }
}
