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

/** The operation libraries of an expression language, adapted to Eclipse OCL. */
public final class Libraries {

  /** The name of the variable that stands for the source of a call without source. */
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

  /** Sets the types of the language. */
  public void belongTo(TypeSystem types) {
    typeSystem = types;
  }

  /** Returns the names of all operations, for hints. */
  List<String> names() {
    return libraries.stream().flatMap(library -> library.names().stream()).distinct().toList();
  }

  /** Returns the operations of all libraries for sources of a type; {@code null} for none. */
  public List<OperationLibrary.Signature> signatures(EClassifier source) {
    return libraries.stream()
        .flatMap(library -> library.signatures(typeSystem, source).stream())
        .toList();
  }

  /** Returns the type of the variable that stands for the source of a call without source. */
  EClass functions() {
    return functions;
  }

  /**
   * Returns the operation of a call; {@code null} if no library has it.
   *
   * @param loosely true to include operations that take only some values of these types
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

  /** An operation of a library as an EOperation for Eclipse OCL. */
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
