package dev.eventchain.ocl.parse;

import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.dialect.TypeSystem;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.impl.EOperationImpl;
import org.eclipse.ocl.utilities.TypedElement;

/** The operation libraries of an expression language, as Eclipse OCL sees them. */
public final class Libraries {

  /** Stands for the source of a call that has none. */
  public static final String NO_SOURCE = "(no source)";

  private record Call(
      EClassifier source, String name, List<EClassifier> argumentTypes, boolean loosely) {}

  private final List<OperationLibrary> libraries;
  private TypeSystem typeSystem;
  private final Map<Call, Optional<LibraryOperation>> known = new HashMap<>();
  private final EClass owner = EcoreFactory.eINSTANCE.createEClass();
  private final EClass functions = EcoreFactory.eINSTANCE.createEClass();

  Libraries(Dialect dialect) {
    this.libraries = new ArrayList<>(dialect.libraries());
    this.libraries.add(new StandardAdditions());
    owner.setName("Library");
    functions.setName(NO_SOURCE);
  }

  /** Says which types the language has whose libraries these are. */
  public void belongTo(TypeSystem types) {
    typeSystem = types;
  }

  /** The names of all operations, for hints. */
  List<String> names() {
    return libraries.stream().flatMap(library -> library.names().stream()).distinct().toList();
  }

  /** The type of the variable that stands for the source of a call that has none. */
  EClass functions() {
    return functions;
  }

  /**
   * The operation that a call means; {@code null} if no library has it.
   *
   * @param loosely whether it may be one that takes only some values of these types
   */
  LibraryOperation lookup(
      EClassifier source,
      String name,
      List<? extends TypedElement<EClassifier>> arguments,
      boolean loosely) {
    List<EClassifier> types = new ArrayList<>();
    if (arguments != null) {
      for (TypedElement<EClassifier> argument : arguments) {
        if (argument == null || argument.getType() == null) {
          return null;
        }
        types.add(argument.getType());
      }
    }
    EClassifier given = source == functions ? null : source;
    return known.computeIfAbsent(new Call(given, name, types, loosely), this::ask).orElse(null);
  }

  private Optional<LibraryOperation> ask(Call call) {
    for (OperationLibrary library : libraries) {
      Optional<OperationLibrary.Operation> found =
          call.loosely()
              ? library.lookupLoosely(typeSystem, call.source(), call.name(), call.argumentTypes())
              : library.lookup(typeSystem, call.source(), call.name(), call.argumentTypes());
      if (found.isPresent()) {
        LibraryOperation operation = new LibraryOperation(call, found.get());
        owner.getEOperations().add(operation);
        return Optional.of(operation);
      }
    }
    return Optional.empty();
  }

  /** An operation of a library in the shape that Eclipse OCL can refer to. */
  public static final class LibraryOperation extends EOperationImpl {
    private final OperationLibrary.Implementation implementation;

    private LibraryOperation(Call call, OperationLibrary.Operation operation) {
      implementation = operation.implementation();
      setName(operation.name());
      setEType(operation.resultType());
      for (int i = 0; i < call.argumentTypes().size(); i++) {
        EParameter parameter = EcoreFactory.eINSTANCE.createEParameter();
        parameter.setName("argument" + (i + 1));
        parameter.setEType(call.argumentTypes().get(i));
        getEParameters().add(parameter);
      }
    }

    public OperationLibrary.Implementation implementation() {
      return implementation;
    }
  }
}
