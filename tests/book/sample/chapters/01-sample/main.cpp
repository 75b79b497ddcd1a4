/*** # A sample of everything

The load is {{F-hertz}}, small ones are {{tiny}}, and $p_0 = {{tiny}}$ in a formula[^1]. See {{fig-1}}, and table {{table-1}}.

[^1]: A footnote with {{F-hertz}}, too.

| case    | value       |
|---------|-------------|
| printed | {{F-hertz}} |

Table: The caption has {{F-hertz}}.

Text in `{{code}}` is left alone. The peak is {{outcome:table-1/p0}}.

$$ a + b \tag{7} $$

The sum is `add(a, b)`.

{{code: sample/add.hpp add}}
*/
#include <string>
#include <vector>

using std::string;

// Templates, < and & must survive.
template <class T>
bool less(const std::vector<T>& a, T b) { return a.size() < 1'000 && a[0] < b; }

int braces[1][1] = {{1}};
const char* text = "/*** not prose */";
const char* raw = R"x(
/*** nor this: {{unknown}} */
)x";
/*** ## Table 1

{{table-1}}

{{include: more.cpp}}

## Error against run time

{{work-precision}}

## Stability

{{stability}}

{{coverage}}

{{symbols}}

::: findings
1. The load is confirmed. {{outcome:table-1/p0}}
:::

It follows by (7); (8) is no equation of this page.

{{verdicts}}

{{checks}}
*/
int main() {}
