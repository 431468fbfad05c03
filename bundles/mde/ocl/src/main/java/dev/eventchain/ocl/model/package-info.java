/**
 * Access to models: contents, extents, features, operations and instances of types. Knows no
 * expression.
 */
package dev.eventchain.ocl.model;
