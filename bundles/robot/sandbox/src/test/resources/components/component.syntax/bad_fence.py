Here is the component:
```python
class TTC:
    pass
```
