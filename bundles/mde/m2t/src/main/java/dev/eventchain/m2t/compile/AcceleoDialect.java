package dev.eventchain.m2t.compile;

import dev.eventchain.m2t.library.OperationTable;
import dev.eventchain.m2t.library.ServiceLibrary;
import dev.eventchain.m2t.services.Services;
import dev.eventchain.m2t.template.CallLibrary;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.dialect.OperationLibrary;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.ocl.types.AnyType;

/**
 * Dialect of OCL in Acceleo 3 templates: calls of templates, queries and Java services, the Acceleo
 * library, and dynamic types.
 */
record AcceleoDialect(List<OperationLibrary> libraries) implements Dialect {
  /** Name of the element type of collections in the OCL library. */
  private static final String ELEMENT_TYPE = "T";

  static AcceleoDialect of(CallLibrary calls, Services services) {
    return new AcceleoDialect(List.of(calls, new OperationTable(), new ServiceLibrary(services)));
  }

  @Override
  public boolean takesAnyElement() {
    return true;
  }

  @Override
  public boolean takesFirstType() {
    return true;
  }

  /** Returns the assumed type: values of unknown type may be model elements. */
  @Override
  public Optional<EClassifier> assumed(EClassifier type) {
    return type instanceof AnyType<?>
        ? Optional.of(EcorePackage.Literals.EOBJECT)
        : Optional.empty();
  }

  @Override
  public boolean meansAnyType(String name) {
    return name.equals(ELEMENT_TYPE);
  }

  @Override
  public Optional<OperationLibrary.Implementation> endOf(
      OperationLibrary.Implementation operation, boolean first) {
    return operation instanceof OperationTable.RowCall row ? row.endOnly(first) : Optional.empty();
  }
}
